//! Judgement of recorded people, with the original and with damaged skeletons.

use bica::Params;
use bica_body::random::Random;

use super::*;

/// Damage of a recording.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Damage {
    None,
    /// A fifth of the skeletons is missing, together with their times.
    Lost,
    /// Every third skeleton only: 10 per second.
    Slow,
    /// Noise of 2 cm (standard deviation) on each axis of each point. Kinect skeletons of UI-PRMD are in centimetres.
    Noise,
}

impl Damage {
    const ALL: [Self; 4] = [Self::None, Self::Lost, Self::Slow, Self::Noise];

    fn rate(self) -> f32 {
        if self == Self::Slow { 10.0 } else { 30.0 }
    }

    fn of(self, mut recording: Recording, random: &mut Random) -> Recording {
        match self {
            Self::None => recording,
            Self::Lost => recording.into_iter().filter(|_| random.unit() > 0.2).collect(),
            Self::Slow => recording.into_iter().step_by(3).collect(),
            Self::Noise => {
                let points = recording.iter_mut().flatten().flat_map(|skeleton| &mut skeleton.points);
                points.flatten().for_each(|axis| *axis += 2.0 * random.normal());
                recording
            }
        }
    }
}

const JUDGING: Judging = Judging { tempo: 0.0, ..Judging::DEFAULT };

/// Judges the recordings of a person. Returns the mean of the rates of correct and incorrect recordings judged as such,
/// and the number of repetitions counted in the joined correct and the joined incorrect recordings.
fn judge_person(movement: &str, person: u32, damage: Damage) -> (f32, [usize; 2]) {
    let (mut random, name) = (Random::new(person.into(), 1_u64), format!("{movement}_s{person:02}"));
    let mut all = |folder: &str| -> Vec<Recording> {
        let found = recordings(&bica_test_data::exercises().join(folder)).expect("a folder");
        let own = found.into_iter().filter(|(_, group)| *group == name);
        own.map(|(path, _)| damage.of(read(&path).expect("a recording"), &mut random)).collect()
    };
    let (correct, incorrect) = (all("correct"), all("incorrect"));
    let example = learn(&correct[..EXAMPLES], damage.rate(), &JUDGING).unwrap_or_else(|| panic!("{name} {damage:?}"));
    let judged = |recording: &[Option<Skeleton>]| verdict(recording, damage.rate(), &example, &JUDGING);
    let share = |recordings: &[Recording], wanted| {
        recordings.iter().filter(|each| judged(each).0.verdict() == wanted).count() as f32 / recordings.len() as f32
    };
    let balanced = 0.5 * (share(&correct[EXAMPLES..], Verdict::Correct) + share(&incorrect, Verdict::Incorrect));
    (balanced, [correct, incorrect].map(|all| judged(&all.concat()).1))
}

bica_test_data::exercises_test! {
    fn recorded_people_are_judged_and_counted() {
        // In extension to the back (m08) the camera does not see the arm: noise costs more there, and the count is unreliable.
        for (movement, least, most) in [("m07", 0.98, 0.05), ("m10", 0.97, 0.05), ("m08", 0.93, 0.1)] {
            let [clean, worse @ ..] = Damage::ALL.map(|damage| {
                let people: Vec<_> = (1..=5).map(|person| judge_person(movement, person, damage)).collect();
                let mut counts = people.iter().flat_map(|(_, counts)| counts);
                assert!(movement == "m08" || counts.all(|count| (9..=11).contains(count)), "{movement} {damage:?}");
                people.iter().map(|(balanced, _)| balanced).sum::<f32>() / people.len() as f32
            });
            println!("{movement}: {clean:.3}, with lost skeletons, slow, with noise {worse:.3?}");
            assert!(clean >= least, "{movement}: {clean}");
            assert!(worse.iter().all(|worse| *worse >= clean - most), "{movement}: {clean} {worse:?}");
        }
    }
}
