//! Requests and responses of the services that a node offers.

use bica_recording::ros::{ListResult, Parameter, ParameterDescriptor, ParameterValue, SetResult};
use ros2_client::Message;
use serde::{Deserialize, Serialize};

/// Declares requests and responses of services.
macro_rules! services {
    ($($name:ident { $($field:ident: $kind:ty),* $(,)? })*) => {$(
        #[derive(Clone, Debug, Default, Serialize, Deserialize)]
        pub(crate) struct $name { $(pub(crate) $field: $kind),* }
        impl Message for $name {}
    )*};
}

services!(
    Names { names: Vec<String> }
    Values { values: Vec<ParameterValue> }
    Types { types: Vec<u8> }
    Descriptors { descriptors: Vec<ParameterDescriptor> }
    List { prefixes: Vec<String>, depth: u64 }
    Listed { result: ListResult }
    Parameters { parameters: Vec<Parameter> }
    Results { results: Vec<SetResult> }
    SingleResult { result: SetResult }
    // A structure without fields has one byte in the encoding of ROS.
    Nothing { structure_needs_at_least_one_member: u8 }
    TriggerResponse { success: bool, message: String }
);
