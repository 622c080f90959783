//! Contacts in a control cycle.

use bica_motion::robot::Buttons;
use bica_motion::side::Side;
use glam::Vec3;
use mujoco_rs::prelude::{MjModel, MjtObjBase};

use super::state::Data;

/// Cosine of the angle between foot and contact within which a bumper is pressed (60°).
const BUMPER_COSINE: f32 = 0.5;

/// The object to which a geom belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Owner {
    Foot(Side),
    /// The robot without its feet.
    Body,
    Floor,
    /// Contact type 8: a static obstacle, such as another robot.
    Obstacle,
    /// Contact type 16: an object that a foot can move.
    Loose,
}

/// Owners of all geoms of a model.
pub(crate) struct GeomOwners(Vec<Owner>);

/// Contacts of the robot during a control cycle.
#[derive(Clone, Copy, Debug, Default)]
pub struct Contacts {
    /// The foot that touched a loose object last.
    pub loose: Option<Side>,
    /// Whether the robot touched an obstacle.
    pub obstacle: bool,
    /// Whether a part of the robot other than its feet touched the floor.
    pub floor: bool,
    /// Pressed bumpers.
    pub buttons: Buttons,
}

impl GeomOwners {
    /// Finds the owners by the names and contact types of the geoms.
    pub(crate) fn of(model: &MjModel) -> Self {
        let owner = |geom: usize| {
            let name = model.id_to_name(MjtObjBase::mjOBJ_GEOM, geom).unwrap_or_default();
            match (name, model.geom_contype()[geom]) {
                ("LSole" | "LFootShell", _) => Owner::Foot(Side::Left),
                ("RSole" | "RFootShell", _) => Owner::Foot(Side::Right),
                (_, 4) => Owner::Floor,
                (_, 8) => Owner::Obstacle,
                (_, 16) => Owner::Loose,
                _ => Owner::Body,
            }
        };
        Self((0..model.geom_contype().len()).map(owner).collect())
    }

    /// Adds the current contacts. `ahead`: forward directions of both feet, left first.
    pub(crate) fn collect(&self, data: &Data, ahead: [Vec3; 2], contacts: &mut Contacts) {
        for contact in data.contact().iter().filter(|contact| contact.dist <= 0.0) {
            let [a, b] = contact.geom.map(|geom| self.0.get(geom as usize).copied());
            let (Some(a), Some(b)) = (a, b) else { continue };
            let normal = Vec3::new(contact.frame[0] as f32, contact.frame[1] as f32, contact.frame[2] as f32);
            contacts.add(a, b, normal, ahead);
            contacts.add(b, a, -normal, ahead);
        }
    }
}

impl Contacts {
    /// Adds a contact between `own` and `other`; `outward`: contact normal from `own` to `other`.
    fn add(&mut self, own: Owner, other: Owner, outward: Vec3, ahead: [Vec3; 2]) {
        match (own, other) {
            (Owner::Foot(side), Owner::Loose) => self.loose = Some(side),
            (Owner::Foot(side), Owner::Obstacle) => {
                self.obstacle = true;
                let pressed = outward.dot(ahead[side.index()]) > BUMPER_COSINE;
                match side {
                    Side::Left => self.buttons.left_bumper |= pressed,
                    Side::Right => self.buttons.right_bumper |= pressed,
                }
            }
            (Owner::Body, Owner::Obstacle) => self.obstacle = true,
            (Owner::Body, Owner::Floor) => self.floor = true,
            _ => {}
        }
    }
}
