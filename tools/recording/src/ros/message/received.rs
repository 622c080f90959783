//! Messages that nodes send to a robot, and their parts.

use serde::{Deserialize, Serialize};

use super::cdr::Byte;
use super::messages;

messages!(derive(Serialize, Deserialize);
    builtin_interfaces/Time as Time { sec: i32, nanosec: u32 }
    geometry_msgs/Vector3 as Vector3 { x: f64, y: f64, z: f64 }
    geometry_msgs/Twist as Twist { linear: Vector3, angular: Vector3 }
    std_msgs/MultiArrayDimension as MultiArrayDimension { label: String, size: u32, stride: u32 }
    std_msgs/MultiArrayLayout as MultiArrayLayout { dim: Vec<MultiArrayDimension>, data_offset: u32 }
    std_msgs/Empty as Empty { structure_needs_at_least_one_member: u8 }
    std_msgs/Float32MultiArray as Numbers { layout: MultiArrayLayout, data: Vec<f32> }
    rcl_interfaces/ParameterValue as ParameterValue {
        r#type: u8, bool_value: bool, integer_value: i64, double_value: f64, string_value: String,
        byte_array_value: Vec<Byte>,
        bool_array_value: Vec<bool>, integer_array_value: Vec<i64>, double_array_value: Vec<f64>,
        string_array_value: Vec<String>,
    }
    rcl_interfaces/Parameter as Parameter { name: String, value: ParameterValue }
    rcl_interfaces/SetParametersResult as SetResult { successful: bool, reason: String }
    rcl_interfaces/FloatingPointRange as FloatingPointRange { from_value: f64, to_value: f64, step: f64 }
    rcl_interfaces/IntegerRange as IntegerRange { from_value: i64, to_value: i64, step: u64 }
    rcl_interfaces/ParameterDescriptor as ParameterDescriptor {
        name: String, r#type: u8, description: String, additional_constraints: String, read_only: bool, dynamic_typing: bool,
        floating_point_range: Vec<FloatingPointRange>, integer_range: Vec<IntegerRange>,
    }
    rcl_interfaces/ListParametersResult as ListResult { names: Vec<String>, prefixes: Vec<String> }
);
