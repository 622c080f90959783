//! The recorded people, as recorded and with worse skeletons.

use std::f32::consts::TAU;

use bica::Params;
use rand_pcg::{Pcg32, rand_core::Rng};

use super::*;

/// How a recording is made worse.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Damage {
    None,
    /// A fifth of the skeletons is missing, and their times with them.
    Lost,
    /// Every third skeleton: 10 a second.
    Slow,
    /// 2 cm at each point along each axis, one standard deviation. Kinect skeletons of UI-PRMD are in centimetres.
    Noise,
}

impl Damage {
    const ALL: [Self; 4] = [Self::None, Self::Lost, Self::Slow, Self::Noise];

    fn rate(self) -> f32 {
        if self == Self::Slow { 10.0 } else { 30.0 }
    }

    fn of(self, recording: Recording, random: &mut Pcg32) -> Recording {
        let mut unit = || (random.next_u32() >> 8) as f32 / (1 << 24) as f32;
        match self {
            Self::None => recording,
            Self::Lost => recording.into_iter().filter(|_| unit() > 0.2).collect(),
            Self::Slow => recording.into_iter().step_by(3).collect(),
            Self::Noise => recording
                .into_iter()
                .map(|skeleton| {
                    let mut skeleton = skeleton?;
                    let mut normal = || libm::sqrtf(-2.0 * libm::logf(1.0 - unit())) * libm::cosf(TAU * unit());
                    skeleton.points = skeleton.points.map(|point| point.map(|axis| axis + 2.0 * normal()));
                    Some(skeleton)
                })
                .collect(),
        }
    }
}

/// A person who does a movement.
struct Group {
    correct: Vec<Recording>,
    incorrect: Vec<Recording>,
    example: Example,
    damage: Damage,
}

const JUDGING: Judging = Judging { tempo: 0.0, ..Judging::DEFAULT };

/// The people who do a movement, as `m07`.
fn people(movement: &str, damage: Damage) -> Vec<Group> {
    let mut random = Pcg32::new(1, 1);
    let mut group = |person: u32| {
        let mut all = |folder: &str| -> Vec<Recording> {
            let found = recordings(&bica_test_data::exercises().join(folder)).expect("a folder");
            let own = found.into_iter().filter(|(_, group)| *group == format!("{movement}_s{person:02}"));
            own.map(|(path, _)| damage.of(read(&path).expect("a recording"), &mut random)).collect()
        };
        let (correct, incorrect) = (all("correct"), all("incorrect"));
        let example = learn(&correct[..EXAMPLES], damage.rate(), &JUDGING)
            .unwrap_or_else(|| panic!("{movement} {person} {damage:?}"));
        Group { correct, incorrect, example, damage }
    };
    (1..=5).map(&mut group).collect()
}

impl Group {
    fn share(&self, recordings: &[Recording], wanted: Verdict) -> f32 {
        let verdicts =
            recordings.iter().map(|each| verdict(each, self.damage.rate(), &self.example, &JUDGING).0.verdict);
        verdicts.filter(|verdict| *verdict == wanted).count() as f32 / recordings.len() as f32
    }
}

/// Mean of the shares of correct and of incorrect recordings that are told so.
fn balanced(movement: &str, damage: Damage) -> f32 {
    let people = people(movement, damage);
    let told = |group: &Group| {
        let correct = group.share(&group.correct[EXAMPLES..], Verdict::Correct);
        0.5 * (correct + group.share(&group.incorrect, Verdict::Incorrect))
    };
    people.iter().map(told).sum::<f32>() / people.len() as f32
}

bica_test_data::exercises_test! {
    fn recorded_people_are_judged_also_with_worse_skeletons() {
        for (movement, least) in [("m07", 0.95), ("m10", 0.92), ("m08", 0.85)] {
            let [clean, worse @ ..] = Damage::ALL.map(|damage| balanced(movement, damage));
            println!("{movement}: {clean:.3}, with lost skeletons, slow, with noise {worse:.3?}");
            assert!(clean >= least, "{movement}: {clean}");
            // Extension to the back is hidden from the camera: noise costs more there.
            let most = if movement == "m08" { 0.1 } else { 0.05 };
            assert!(worse.iter().all(|worse| *worse >= clean - most), "{movement}: {clean} {worse:?}");
        }
    }

    fn ten_repetitions_are_counted_as_ten() {
        for damage in Damage::ALL {
            let counts = ["m07", "m10"].into_iter().flat_map(|movement| people(movement, damage)).flat_map(|group| {
                [&group.correct, &group.incorrect].map(|recordings| {
                    verdict(&recordings.concat(), damage.rate(), &group.example, &JUDGING).1
                })
            });
            let counts: Vec<_> = counts.collect();
            assert!(counts.iter().all(|count| (9..=11).contains(count)), "{damage:?}: {counts:?}");
        }
    }
}
