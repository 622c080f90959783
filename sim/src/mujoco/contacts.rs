//! What touches what in a cycle.

use bica_motion::robot::Buttons;
use bica_motion::side::Side;
use glam::Vec3;
use mujoco_rs::prelude::{MjData, MjModel, MjtObjBase};

/// A foot feels what is within this of its front, as the cosine of the angle.
const BUMPER: f32 = 0.5;

/// What a geom belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Owner {
    Foot(Side),
    /// The robot without its feet.
    Body,
    Floor,
    /// Post, net, another robot.
    Thing,
    Ball,
}

/// Knows what every geom belongs to.
pub(crate) struct Owners(Vec<Owner>);

/// What touched what.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Touches {
    /// The foot that touched the ball.
    pub(crate) ball: Option<Side>,
    /// Whether the robot touched a thing.
    pub(crate) thing: bool,
    /// Whether more of the robot than its feet touched the floor.
    pub(crate) ground: bool,
    /// Bumpers that were pressed.
    pub(crate) buttons: Buttons,
}

impl Owners {
    pub(crate) fn of(model: &MjModel) -> Self {
        let owner = |geom: usize| {
            let name = model.id_to_name(MjtObjBase::mjOBJ_GEOM, geom).unwrap_or_default();
            match (name, model.geom_contype()[geom]) {
                ("LSole" | "LShoe", _) => Owner::Foot(Side::Left),
                ("RSole" | "RShoe", _) => Owner::Foot(Side::Right),
                (_, 4) => Owner::Floor,
                (_, 8) => Owner::Thing,
                (_, 16) => Owner::Ball,
                _ => Owner::Body,
            }
        };
        Self((0..model.geom_contype().len()).map(owner).collect())
    }

    /// Adds what touches what now. `ahead`: the directions of both feet, left first.
    pub(crate) fn look(&self, data: &MjData<Box<MjModel>>, ahead: [Vec3; 2], touches: &mut Touches) {
        for contact in data.contact().iter().filter(|contact| contact.dist <= 0.0) {
            let [a, b] = contact.geom.map(|geom| self.0.get(geom as usize).copied());
            let (Some(a), Some(b)) = (a, b) else { continue };
            let normal = Vec3::new(contact.frame[0] as f32, contact.frame[1] as f32, contact.frame[2] as f32);
            touches.note(a, b, normal, ahead);
            touches.note(b, a, -normal, ahead);
        }
    }
}

impl Touches {
    /// Something of the robot's touches something else, in the direction of `out` from it.
    fn note(&mut self, own: Owner, other: Owner, out: Vec3, ahead: [Vec3; 2]) {
        match (own, other) {
            (Owner::Foot(side), Owner::Ball) => self.ball = Some(side),
            (Owner::Foot(side), Owner::Thing) => {
                self.thing = true;
                let pressed = out.dot(ahead[side.index()]) > BUMPER;
                match side {
                    Side::Left => self.buttons.left_bumper |= pressed,
                    Side::Right => self.buttons.right_bumper |= pressed,
                }
            }
            (Owner::Body, Owner::Thing) => self.thing = true,
            (Owner::Body, Owner::Floor) => self.ground = true,
            _ => {}
        }
    }
}
