//! Driving by `cmd_vel`.

use std::time::{Duration, Instant};

use bica::runner::Request;
use bica::{ComponentId, Hold, Value};
use bica_link::{Client, Error};
use bica_recording::ros::{Twist, Vector3};
use bica_wire::model::{Description, Kind, Modulation, Output, Param, Plain};

/// Silence after which the robot is stopped.
const SILENCE: Duration = Duration::from_millis(500);

/// Returns the components with an output that gives the place of a frame.
fn guides(description: &Description) -> Vec<ComponentId> {
    let is_place = |output: &Output| output.placement.as_ref().is_some_and(|one| one.child.is_some());
    let components = description.components.iter().enumerate().filter(|(_, one)| one.outputs.iter().any(is_place));
    components.map(|(index, _)| ComponentId::new(index)).collect()
}

/// The modulation that moves a robot.
#[derive(Debug)]
pub(super) struct Drive {
    root: ComponentId,
    component: ComponentId,
    modulation: u16,
    arguments: Vec<Param>,
    /// Components that determine places of frames, such as odometry. They are held active, because a driver needs them, too.
    guides: Vec<ComponentId>,
    /// Whether the tree's own behaviour is held latent.
    is_held: bool,
    /// Time of the last command; `None` if its speeds were zero.
    moving: Option<Instant>,
    /// Whether the last command contained a number that is not finite. Only the first of several is reported.
    is_refused: bool,
}

impl Drive {
    /// Finds the first modulation that drives the body: one that drives and takes a speed ahead.
    pub(super) fn find(description: &Description) -> Option<Self> {
        let components = description.components.iter().enumerate();
        let mut all =
            components.flat_map(|(index, one)| one.modulations.iter().zip(0..).map(move |called| (index, called)));
        let moves_body = |called: &Modulation| called.arguments.iter().any(|param| param.name == "forward");
        let found = all.find(|(_, (called, _))| called.drives && moves_body(called));
        found.map(|(component, (called, modulation))| Self {
            root: ComponentId::new(description.root),
            component: ComponentId::new(component),
            modulation,
            arguments: called.arguments.clone(),
            guides: guides(description),
            is_held: false,
            moving: None,
            is_refused: false,
        })
    }

    /// Checks that all numbers are finite, also as `f32`, the robot's type. A message with other numbers counts as silence.
    ///
    /// # Errors
    /// The refusal; none if the message before was refused, too.
    pub(super) fn check(&mut self, twist: &Twist) -> Result<(), Option<String>> {
        let numbers = [&twist.linear, &twist.angular].map(|Vector3 { x, y, z }| [*x, *y, *z]);
        let is_finite = numbers.as_flattened().iter().all(|number| (*number as f32).is_finite());
        let was_refused = std::mem::replace(&mut self.is_refused, !is_finite);
        let text = "a speed of cmd_vel is not a finite number: it moves nothing; send finite speeds";
        if is_finite { Ok(()) } else { Err((!was_refused).then(|| text.to_owned())) }
    }

    /// Moves the robot; speeds are limited to their ranges. The tree's root is held latent.
    pub(super) fn drive(&mut self, link: &mut Client, Twist { linear, angular }: &Twist) -> Result<(), Error> {
        let speed = |param: &Param| {
            let speed = match param.name.as_str() {
                "forward" => linear.x,
                "left" => linear.y,
                _ => angular.z,
            };
            let Kind::F32 { min, max, .. } = param.kind else { return None };
            param.value_of(&Plain::Number(speed.clamp(min.into(), max.into()))).ok()
        };
        let Some(speeds) = self.arguments.iter().map(speed).collect::<Option<Vec<_>>>() else { return Ok(()) };
        if !self.is_held {
            link.send_request(Request::Hold { component: self.root, hold: Hold::Latent })?;
            link.send_request(Request::Hold { component: self.component, hold: Hold::Active })?;
            for &component in &self.guides {
                link.send_request(Request::Hold { component, hold: Hold::Active })?;
            }
            self.is_held = true;
        }
        let moves = speeds.iter().any(|speed| *speed != Value::F32(0.0));
        self.moving = moves.then(Instant::now);
        let (component, modulation) = (self.component, self.modulation);
        link.send_request(Request::Modulate { component, modulation, arguments: &speeds })?;
        Ok(())
    }

    /// Stops the robot if its driver is silent, and resets this state if the lease has ended.
    pub(super) fn end_silence(&mut self, link: &mut Client) -> Result<(), Error> {
        if !link.lease().yours {
            (self.is_held, self.moving) = (false, None);
        } else if self.moving.is_some_and(|moving| moving.elapsed() > SILENCE) {
            self.drive(link, &Twist::default())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use bica::prelude::*;

    use super::*;

    struct Wheels(f32);

    /// Its first modulation only looks like one that drives.
    #[component]
    impl Wheels {
        const fn new() -> Self {
            Self(0.0)
        }

        /// Last request.
        #[output]
        fn last(&self) -> f32 {
            self.0
        }

        /// Sets limits.
        #[modulation]
        fn limit(&mut self, #[range(0.0..=1.0)] forward: f32, #[range(0.0..=1.0)] turn: f32) {
            self.0 = forward + turn;
        }

        /// Looks.
        #[modulation(drives)]
        fn look(
            &mut self,
            #[range(-1.0..=1.0)]
            #[unit("rad")]
            pan: f32,
        ) {
            self.0 = pan;
        }

        /// Requests a speed.
        #[modulation(drives)]
        fn go(
            &mut self,
            #[range(-1.0..=1.0)]
            #[unit("rad/s")]
            turn: f32,
            #[range(0.0..=1.0)]
            #[unit("m/s")]
            forward: f32,
        ) {
            self.0 = turn + forward;
        }
    }

    activation_tree! { struct Cart { root: Wheels, cycle_hz: 50, components: [Wheels] } }

    #[test]
    fn only_what_says_so_drives_the_body() {
        let mut description = Description::of(&Cart::GRAPH);
        let drive = Drive::find(&description).expect("a modulation that drives");
        assert_eq!((drive.modulation, drive.arguments[0].name.as_str()), (2, "turn"));
        description.components[0].modulations.pop();
        assert!(Drive::find(&description).is_none());
    }

    #[test]
    fn a_speed_that_is_no_number_is_refused_once() {
        let mut drive = Drive {
            root: ComponentId::new(0),
            component: ComponentId::new(1),
            modulation: 0,
            arguments: Vec::new(),
            guides: Vec::new(),
            is_held: false,
            moving: None,
            is_refused: false,
        };
        let ahead = |x| Twist { linear: Vector3 { x, ..Vector3::default() }, ..Twist::default() };
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
            assert!(drive.check(&ahead(wrong)).is_err_and(|text| text.is_some()), "{wrong}");
            assert_eq!(drive.check(&ahead(wrong)), Err(None), "{wrong}");
            assert_eq!(drive.check(&ahead(5.0)), Ok(()), "a finite speed beyond the range is accepted");
        }
        let turn = Twist { angular: Vector3 { x: f64::NAN, ..Vector3::default() }, ..ahead(0.1) };
        assert!(drive.check(&turn).is_err(), "all numbers of a message are checked");
    }
}
