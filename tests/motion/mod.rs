//! Tests of the algorithms against references and in a quasi-static world.

mod adjustment;
mod bounds;
mod dribble;
mod falls;
mod forces;
mod head;
mod health;
mod joints;
mod kick;
mod kinematics;
mod messages;
mod model;
mod nao;
mod odometry;
mod pose;
mod quadratic_program;
mod recovery;
mod sense_faults;
mod senses;
mod simulated;
mod tall;
mod walk;
mod world;

use proptest::prelude::ProptestConfig;

/// Configuration with a number of random cases.
fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}
