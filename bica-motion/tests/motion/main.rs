//! What the body can do, checked against references and in a quasi-static world.

mod dribble;
mod falls;
mod forces;
mod head;
mod health;
mod joints;
mod kick;
mod kinematics;
mod odometry;
mod walk;
mod world;

use proptest::prelude::ProptestConfig;

/// This many random cases.
fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}
