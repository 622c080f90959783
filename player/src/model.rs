//! The model of the controlled robot.

use bica::{Has, Tree};
use bica_motion::model::RobotModel;

use crate::behaviour::SafetyGuard;
use crate::input::{HealthMonitor, RobotProfile, RobotState};
use crate::motion::{Head, Walk};
use crate::output::Motors;
use crate::perception::Odometry;

/// Makes a tree control another robot than [`MODEL`](crate::MODEL): its joints, limits, lengths and motions. Call it before the first
/// cycle; it also sets the model's profile for a world without dynamics.
pub fn set_model<T>(tree: &mut T, model: &'static RobotModel)
where
    T: Tree
        + Has<RobotProfile>
        + Has<RobotState>
        + Has<HealthMonitor>
        + Has<Motors>
        + Has<Walk>
        + Has<Head>
        + Has<Odometry>
        + Has<SafetyGuard>,
{
    tree.get_mut::<RobotProfile>().set_model(model);
    tree.get_mut::<RobotState>().set_model(model);
    tree.get_mut::<HealthMonitor>().set_model(model);
    tree.get_mut::<Motors>().set_model(model);
    tree.get_mut::<Walk>().set_model(model);
    tree.get_mut::<Head>().set_model(model);
    tree.get_mut::<Odometry>().set_model(model);
    tree.get_mut::<SafetyGuard>().set_model(model);
}
