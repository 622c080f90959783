//! Messages that a robot sends.

use super::cdr::{Byte, Fixed};
use super::messages;
use super::received::{MultiArrayLayout, Parameter, Time, Twist, Vector3};

messages!(derive();
    builtin_interfaces/Duration as Duration { sec: i32, nanosec: u32 }
    bica_msgs/Event as Event { data: Vec<u8> }
    rosgraph_msgs/Clock as Clock { clock: Time }
    std_msgs/Header as Header { stamp: Time, frame_id: String }
    std_msgs/String as Text { data: String }
    std_msgs/Bool as Bool { data: bool }
    std_msgs/Float32 as Float32 { data: f32 }
    std_msgs/Float64 as Float64 { data: f64 }
    std_msgs/Int64 as Int64 { data: i64 }
    std_msgs/UInt64 as UInt64 { data: u64 }
    std_msgs/ColorRGBA as Color { r: f32, g: f32, b: f32, a: f32 }
    std_msgs/Float64MultiArray as Numbers64 { layout: MultiArrayLayout, data: Vec<f64> }
    geometry_msgs/Point as Point { x: f64, y: f64, z: f64 }
    geometry_msgs/Quaternion as Quaternion { x: f64, y: f64, z: f64, w: f64 }
    geometry_msgs/Pose as Pose { position: Point, orientation: Quaternion }
    geometry_msgs/PointStamped as PointStamped { header: Header, point: Point }
    geometry_msgs/PoseStamped as PoseStamped { header: Header, pose: Pose }
    geometry_msgs/PoseWithCovariance as PoseWithCovariance { pose: Pose, covariance: Fixed<36> }
    geometry_msgs/PoseWithCovarianceStamped as PoseWithCovarianceStamped { header: Header, pose: PoseWithCovariance }
    geometry_msgs/TwistWithCovariance as TwistWithCovariance { twist: Twist, covariance: Fixed<36> }
    geometry_msgs/Transform as Transform { translation: Vector3, rotation: Quaternion }
    geometry_msgs/TransformStamped as TransformStamped { header: Header, child_frame_id: String, transform: Transform }
    tf2_msgs/TFMessage as Transforms { transforms: Vec<TransformStamped> }
    nav_msgs/Odometry as Odometry {
        header: Header, child_frame_id: String, pose: PoseWithCovariance, twist: TwistWithCovariance,
    }
    nav_msgs/Path as Path { header: Header, poses: Vec<PoseStamped> }
    sensor_msgs/LaserScan as LaserScan {
        header: Header, angle_min: f32, angle_max: f32, angle_increment: f32, time_increment: f32, scan_time: f32,
        range_min: f32, range_max: f32, ranges: Vec<f32>, intensities: Vec<f32>,
    }
    sensor_msgs/Imu as Imu {
        header: Header, orientation: Quaternion, orientation_covariance: Fixed<9>, angular_velocity: Vector3,
        angular_velocity_covariance: Fixed<9>, linear_acceleration: Vector3, linear_acceleration_covariance: Fixed<9>,
    }
    sensor_msgs/JointState as JointState {
        header: Header, name: Vec<String>, position: Vec<f64>, velocity: Vec<f64>, effort: Vec<f64>,
    }
    sensor_msgs/CompressedImage as CompressedImage { header: Header, format: String, data: Vec<u8> }
    sensor_msgs/RegionOfInterest as RegionOfInterest {
        x_offset: u32, y_offset: u32, height: u32, width: u32, do_rectify: bool,
    }
    sensor_msgs/CameraInfo as CameraInfo {
        header: Header, height: u32, width: u32, distortion_model: String, d: Vec<f64>, k: Fixed<9>, r: Fixed<9>,
        p: Fixed<12>, binning_x: u32, binning_y: u32, roi: RegionOfInterest,
    }
    sensor_msgs/PointField as PointField { name: String, offset: u32, datatype: u8, count: u32 }
    sensor_msgs/PointCloud2 as PointCloud {
        header: Header, height: u32, width: u32, fields: Vec<PointField>, is_bigendian: bool, point_step: u32,
        row_step: u32, data: Vec<u8>, is_dense: bool,
    }
    visualization_msgs/UVCoordinate as UvCoordinate { u: f32, v: f32 }
    visualization_msgs/MeshFile as MeshFile { filename: String, data: Vec<u8> }
    visualization_msgs/Marker as Marker {
        header: Header, ns: String, id: i32, r#type: i32, action: i32, pose: Pose, scale: Vector3, color: Color,
        lifetime: Duration, frame_locked: bool, points: Vec<Point>, colors: Vec<Color>, texture_resource: String,
        texture: CompressedImage, uv_coordinates: Vec<UvCoordinate>, text: String, mesh_resource: String,
        mesh_file: MeshFile, mesh_use_embedded_materials: bool,
    }
    visualization_msgs/MarkerArray as MarkerArray { markers: Vec<Marker> }
    diagnostic_msgs/KeyValue as KeyValue { key: String, value: String }
    diagnostic_msgs/DiagnosticStatus as DiagnosticStatus {
        level: Byte, name: String, message: String, hardware_id: String, values: Vec<KeyValue>,
    }
    diagnostic_msgs/DiagnosticArray as DiagnosticArray { header: Header, status: Vec<DiagnosticStatus> }
    rcl_interfaces/ParameterEvent as ParameterEvent {
        stamp: Time, node: String, new_parameters: Vec<Parameter>, changed_parameters: Vec<Parameter>,
        deleted_parameters: Vec<Parameter>,
    }
    rcl_interfaces/Log as Log {
        stamp: Time, level: u8, name: String, msg: String, file: String, function: String, line: u32,
    }
);
