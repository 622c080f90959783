//! The one place that passes sensor values to a tree's components, and takes its command.

use bica::{Has, Tree};
use bica_motion::robot::{CameraId, Command, Light, Lights, Sensors};

use crate::input::{CameraInput, FrameTooLarge, HealthMonitor, RobotState};
use crate::output::Motors;

/// Passes what the body measures, without its image and its buttons.
pub fn measure<T>(tree: &mut T, sensors: &Sensors<'_>)
where
    T: Tree + Has<Motors> + Has<RobotState> + Has<HealthMonitor>,
{
    let commanded = *tree.get::<Motors>().commanded();
    tree.get_mut::<RobotState>().measure(sensors, &commanded);
    tree.get_mut::<HealthMonitor>().check(sensors, &commanded);
}

/// Passes the image, if there is one. Call [`measure`] before it: the image belongs to those joint angles.
///
/// # Errors
/// The image does not fit into [`CameraInput`], which keeps the one before it.
pub fn see<T>(tree: &mut T, sensors: &Sensors<'_>) -> Result<(), FrameTooLarge>
where
    T: Tree + Has<RobotState> + Has<CameraInput>,
{
    let Some(image) = &sensors.image else { return Ok(()) };
    let angles = *tree.get::<RobotState>().angles();
    tree.get_mut::<CameraInput>().receive(image, &angles)
}

/// Returns the command of the cycle, with a colour of the chest light and the top camera.
pub fn command<T>(tree: &mut T, chest: Light) -> Command
where
    T: Tree + Has<Motors> + Has<HealthMonitor>,
{
    let stiffness = tree.get::<HealthMonitor>().derated(tree.get::<Motors>().stiffness());
    let commanded = *tree.get_mut::<Motors>().command(stiffness);
    Command {
        targets: commanded.targets,
        stiffness: commanded.stiffness,
        lights: Lights { chest, ..Lights::default() },
        camera: CameraId::Top,
    }
}
