//! Random faults at random times: no message breaks the interface, and each run ends.

use bica_booster::message::LowState;
use bica_booster::{Gait, K1, T1};
use bica_motion::joints::Joints;
use bica_motion::robot::Command;
use proptest::prelude::*;

use crate::stand_in::StandIn;

#[derive(Clone, Copy, Debug)]
enum Fault {
    Silence,
    Deaf,
    Refuses,
    Nan,
    Count,
    Lies,
    Leaves(i64),
    Jumps,
    Slow,
}

fn fault() -> impl Strategy<Value = Fault> {
    use Fault::{Count, Deaf, Jumps, Leaves, Lies, Nan, Refuses, Silence, Slow};
    let plain = prop::sample::select(vec![Silence, Deaf, Refuses, Nan, Count, Lies, Jumps, Slow]);
    prop_oneof![8 => plain, 1 => (0_i64..5).prop_map(Leaves)]
}

fn nan(state: &mut LowState) {
    state.imu_state.gyro[1] = f32::NAN;
}

fn begin(robot: &mut StandIn, fault: Fault) {
    match fault {
        Fault::Silence => robot.is_silent = true,
        Fault::Deaf => robot.is_deaf = true,
        Fault::Refuses => robot.status = 502,
        Fault::Nan => robot.spoil = Some(nan),
        Fault::Count => robot.spoil = Some(|state| state.motor_state_serial.truncate(7)),
        Fault::Lies => robot.rpy = [1.5, 0.0, 0.0],
        Fault::Leaves(mode) => {
            robot.mode = mode;
            robot.tolerated = 2000;
        }
        Fault::Jumps => {
            robot.program = |_, cycle| {
                let side = if cycle % 7 < 3 { 9.0 } else { -9.0 };
                Some(Command::new(Joints::all(side), 1.0))
            };
        }
        Fault::Slow => robot.delay = 400,
    }
}

fn mend(robot: &mut StandIn) {
    (robot.is_silent, robot.is_deaf, robot.status, robot.spoil, robot.delay) = (false, false, 0, None, 5);
    robot.rpy = [0.0; 3];
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]
    #[test]
    fn no_fault_breaks_the_interface(
        faults in prop::collection::vec((0_u64..3000, fault(), 1_u64..2500), 0..6),
        is_t1 in any::<bool>(),
        is_own in any::<bool>(),
        mut after in 0_u64..3000,
    ) {
        let gait = if is_own { Gait::Own } else { Gait::Firmware };
        let mut robot = StandIn::new(if is_t1 { T1 } else { K1 }, gait);
        for (before, fault, lasts) in faults {
            robot.run(before);
            begin(&mut robot, fault);
            robot.run(lasts);
            mend(&mut robot);
        }
        after += 1;
        robot.run(after);
        robot.stop = true;
        robot.run_to_the_end();
        prop_assert!(!robot.has_gains());
    }
}
