//! Sessions longer than ten minutes.

use std::fs;

use bica_motion::model::NAO;
use bica_test_data::process::Folder;

use super::*;

/// Writes a silent song of three minutes: 8000 bytes per second.
fn song(folder: &Path) {
    let size: u32 = 180 * 8000;
    let mut wav = b"RIFF\0\0\0\0WAVEfmt \x10\0\0\0\x01\0\x01\0\x40\x1f\0\0\x40\x1f\0\0\x01\0\x08\0data".to_vec();
    wav.extend(size.to_le_bytes());
    wav.resize(wav.len() + size as usize, 128);
    fs::write(folder.join("song.wav"), wav).expect("a file");
}

/// Plays a session with one body for each seed. Requires: no fall, no joint beyond its range or faster than 65 °/s, and
/// each command within 100 ms of its place.
pub(super) fn play_long(name: &str, seeds: RangeInclusive<u64>, body: impl Fn(u64) -> Body) {
    let files = Folder::new(name);
    let folder = files.path();
    song(folder);
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("sessions/{name}.session"));
    let script = Script::parse(&fs::read_to_string(file).expect("a session")).expect("a right session");
    assert_eq!(script.check_files(folder), []);
    for seed in seeds {
        let room = Room { body: body(seed), ..Room::new(script.orders(folder), seed, true, true) };
        let mut test = Harness::new(Therapist::new()).in_world(room);
        let (mut last, mut at_once, mut latest, mut fastest) = (angles(&test), 0, 0, 0.0_f32);
        while test.state::<Session>() != Some("finished") {
            test.cycle();
            let angles = angles(&test);
            // The stops of the fingers, which stay closed, yield by 0.007° in MuJoCo.
            let beyond = way(&angles, &angles.clamp_to_limits(NAO));
            assert!(beyond < 0.01, "{name} {seed} {:?}: {beyond}° beyond the limits, {angles:?}", test.now());
            fastest = fastest.max(100.0 * way(&last, &angles));
            // Number of consecutive cycles in `running`: each command must begin within 100 ms.
            at_once = if test.state::<Session>() == Some("running") { at_once + 1 } else { 0 };
            latest = latest.max(10 * at_once);
            last = angles;
        }
        let (minutes, fell) = (test.now().as_secs() as f32 / 60.0, has_fallen(&test));
        println!("{name} {seed}: {minutes:.1} min, fell: {fell}, {fastest:.1} °/s, {latest} ms");
        assert!((10.0..20.0).contains(&minutes) && !fell && fastest <= 65.0 && latest <= 100);
    }
}
