//! Data of a running robot that its graph does not contain.

use postcard_schema::schema::owned::OwnedNamedType;
use serde::{Deserialize, Serialize};

use super::Description;
use crate::Recordable;
use crate::read;

/// Schemas of the messages of a robot.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Messages {
    /// Schema of the sensor values.
    pub sensors: OwnedNamedType,
    /// Schema of the command.
    pub command: OwnedNamedType,
}

impl Messages {
    /// The schemas of a robot's messages.
    #[must_use]
    pub fn of<R: Recordable>() -> Self {
        Self { sensors: R::SENSORS.into(), command: R::COMMAND.into() }
    }
}

impl Description {
    /// Adds the data of a robot of this tree: the values of its parameters, and the schemas of its outputs and messages.
    #[must_use]
    pub fn of_robot<R: Recordable>(mut self, robot: &R) -> Self {
        self.messages = Some(Messages::of::<R>());
        for (component, described) in self.components.iter_mut().enumerate() {
            for (index, param) in described.params.iter_mut().enumerate() {
                param.value = robot.at(component).ok().and_then(|component| component.param(index));
            }
            for (index, output) in described.outputs.iter_mut().enumerate() {
                output.schema = read::schema(robot, component, index).map(Into::into);
            }
        }
        self
    }
}
