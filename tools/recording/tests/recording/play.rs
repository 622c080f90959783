//! Recordings that are played to monitors.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use bica::prelude::*;
use bica::runner::{Request, Robot};
use bica::{Hold, Setting, Value};
use bica_link::{Address, Client, ClientOptions, Error, Event, Memory};
use bica_recording::{Header, ImagePolicy, PlayOptions, Played, Recorder, play};
use bica_wire::message::{ExtraKind, Offers, RefusalCode};
use bica_wire::model::Invalid;

use crate::replay::Temporary;
use crate::support::{Cart, Counter, Disk, cycles, header, pixels, recorded, run_with, small_chunks};

/// Longest wait of a test that fails.
const LIMIT: Duration = Duration::from_mins(1);

/// Returns a recording of 60 cycles in which the gain becomes 0.5 before cycle 7.
fn recorded_change() -> Vec<u8> {
    let disk = Disk::default();
    let recorder = Recorder::start(disk.clone(), &header(ImagePolicy::All), small_chunks(), |_| {}).expect("memory");
    run_with(recorder, 0, 60, &[Setting::new(Cart::id::<Counter>(), 0, Value::F32(0.5))]);
    disk.contents()
}

/// A cart as at the start of the recordings.
fn cart(header: &Header) -> Result<Box<Cart>, Invalid> {
    let is_start = header.assignments().eq(["Counter.gain=1.0"]);
    if is_start { Ok(Box::new(Cart::new())) } else { Err(Invalid::new("other parameters", "record it again")) }
}

fn options<'a>(path: &'a Path, address: &'a Address) -> PlayOptions<'a> {
    PlayOptions { path, address, anywhere: false, speed: 1.0, from: 0.0, until: f64::INFINITY, repeats: false }
}

/// Plays a recording to a monitor again and again, at five times its speed.
fn played(file: &Temporary, from: f64, monitor: impl FnOnce(&mut Client)) -> Played {
    let (address, ends) = (Address::Memory(Memory::default()), AtomicBool::new(false));
    let options = PlayOptions { speed: 5.0, from, repeats: true, ..options(&file.0, &address) };
    thread::scope(|scope| {
        let player = scope.spawn(|| {
            play(&options, cart, |_| Ok(()), || !ends.load(Ordering::Relaxed)).expect("a recording of the cart")
        });
        let began = Instant::now();
        let connected = || Client::connect(&address, ClientOptions::default());
        let mut client = std::iter::repeat_with(connected)
            .inspect(|_| thread::sleep(Duration::from_millis(5)))
            .find(|client| client.is_ok() || began.elapsed() > LIMIT)
            .expect("endless")
            .expect("a server");
        let end = EndAtDrop(&ends);
        monitor(&mut client);
        drop(end);
        player.join().expect("no panic")
    })
}

/// Ends the player also if the monitor's test fails.
struct EndAtDrop<'a>(&'a AtomicBool);

impl Drop for EndAtDrop<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// Takes events until the function returns that it has seen all.
fn until(client: &mut Client, what: &str, mut has_all: impl FnMut(&Client, Event) -> bool) {
    let began = Instant::now();
    loop {
        let event = client.poll(Duration::from_millis(100)).expect("a connection");
        if event.is_some_and(|event| has_all(client, event)) {
            return;
        }
        assert!(began.elapsed() < LIMIT, "there is no {what}");
    }
}

#[test]
fn monitor_sees_what_was_recorded() {
    let content = recorded_change();
    let file = Temporary::new("played.mcap", &content);
    let (recorded, _) = cycles(&content[..]);
    let with_image: BTreeSet<_> = (0..60).filter(|cycle| cycle % 3 == 0).collect();
    let report = played(&file, 0.0, |client| {
        assert_eq!((client.description().name.as_str(), client.is_realtime()), ("Cart", true));
        client.watch(1).unwrap();
        client.watch_output(1, 0, 1).unwrap();
        client.watch_extra(ExtraKind::Images, 1).unwrap();
        let mut missing = BTreeSet::from(["snapshot", "held", "output", "image", "log", "event", "request", "gain"]);
        until(client, "cycle like the recorded one", |client, event| {
            match event {
                Event::Snapshot(snapshot) => {
                    let (cycle, time_us) = (snapshot.info.cycle % 60, snapshot.info.time_us);
                    assert_eq!(time_us, 10_000 * snapshot.info.cycle, "time goes on");
                    let recorded = &recorded[cycle as usize];
                    for (index, state) in snapshot.states.iter().enumerate() {
                        let of_recording = (recorded.tree.is_active(index), recorded.tree.state(index));
                        assert_eq!((state.active, state.state.map(usize::from)), of_recording, "cycle {cycle}");
                    }
                    missing.remove("snapshot");
                    if cycle >= 7 && snapshot.states[1].held == Hold::Active {
                        missing.remove("held");
                    }
                }
                Event::Output { cycle, value, .. } => {
                    let cycle = (cycle % 60) as usize;
                    let values = recorded[..=cycle].iter().rev().find_map(|recorded| recorded.outputs.as_ref());
                    let of_recording = values.and_then(|record| record.values.iter().find(|one| one.component == 1));
                    if let Some(of_recording) = of_recording {
                        assert_eq!(value.as_deref(), Some(&of_recording.value[..]), "cycle {cycle}");
                        missing.remove("output");
                    }
                }
                Event::Image(image) => {
                    let cycle = image.time_us / 10_000 % 60;
                    assert!(with_image.contains(&cycle) && &*image.camera == "camera", "{cycle}");
                    assert_eq!(*image.yuyv, pixels(cycle));
                    missing.remove("image");
                }
                Event::Happened { kind, .. } if kind == "goal" => drop(missing.remove("event")),
                Event::Requested { request: bica::runner::Change::Params(_), .. } => drop(missing.remove("request")),
                Event::Params { component: 1 } => {
                    let gain = client.description().components[1].params[0].value;
                    if gain == Some(Value::F32(0.5)) {
                        missing.remove("gain");
                    }
                }
                _ => {}
            }
            missing.remove("log");
            missing.is_empty()
        });
    });
    assert!(report.cycles > 10 && report.damage.is_none(), "{report:?}");
}

#[test]
fn requests_to_a_recording_are_refused_with_a_reason() {
    let file = Temporary::new("played-refused.mcap", &recorded(60));
    played(&file, 0.0, |client| {
        let offers = Offers::CONDITIONS.with(Offers::IMAGES);
        assert_eq!(client.offers(), offers, "neither operation nor costs");
        let refused = client.request(Request::Hold { component: Cart::id::<Counter>(), hold: Hold::Latent });
        let Err(Error::Refused { code: RefusalCode::Unsupported, text, .. }) = refused else { panic!("{refused:?}") };
        assert!(text.contains("a recording that is played") && text.contains("the robot itself"), "{text}");
        assert!(matches!(client.acquire(false), Err(Error::NotOffered(_))));
    });
}

#[test]
fn span_begins_with_the_values_of_its_past() {
    let content = recorded_change();
    let file = Temporary::new("played-span.mcap", &content);
    played(&file, 0.2, |client| {
        client.watch(1).unwrap();
        until(client, "cycle of the span", |client, event| {
            let Event::Snapshot(snapshot) = event else { return false };
            assert!(snapshot.info.cycle >= 20 && snapshot.states[1].held == Hold::Active, "{snapshot:?}");
            client.description().components[1].params[0].value == Some(Value::F32(0.5))
        });
    });
    let address = Address::Memory(Memory::default());
    let span = |from, until| {
        let options = PlayOptions { from, until, speed: 100.0, ..options(&file.0, &address) };
        play(&options, cart, |_| Ok(()), || true)
    };
    assert_eq!(span(0.1, 0.2).map(|played| played.cycles).expect("11 cycles"), 11);
    let refused = span(5.0, 6.0).expect_err("it is shorter");
    assert!(refused.what.contains("played-span.mcap` has no cycle in the span"), "{refused}");
}

#[test]
fn speed_scales_the_recorded_time() {
    let file = Temporary::new("played-speed.mcap", &recorded(31));
    let address = Address::Memory(Memory::default());
    for (speed, shortest) in [(1.0, 0.3), (0.5, 0.6), (10.0, 0.03)] {
        let (began, options) = (Instant::now(), PlayOptions { speed, ..options(&file.0, &address) });
        let played = play(&options, cart, |_| Ok(()), || true).expect("a recording");
        let seconds = began.elapsed().as_secs_f64();
        assert_eq!((played.cycles, played.passes), (31, 1));
        assert!((shortest..shortest + 5.0).contains(&seconds), "{seconds} s at {speed}");
    }
}

#[test]
fn end_of_a_played_recording_is_its_result() {
    let file = Temporary::new("played-end.mcap", &recorded(60));
    let address = Address::Memory(Memory::default());
    let options = options(&file.0, &address);
    thread::scope(|scope| {
        let (sender, receiver) = std::sync::mpsc::channel();
        let started = move |_: &str| sender.send(()).map_err(|_| Invalid::new("nobody listens", "listen"));
        let player = scope.spawn(move || play(&options, cart, started, || true).expect("a recording"));
        receiver.recv().expect("it starts");
        let mut client = Client::connect(&address, ClientOptions::default()).expect("a server");
        let (began, mut end, mut result) = (Instant::now(), None, None);
        // What came with the end is taken after it.
        while end.is_none() || result.is_none() {
            assert!(began.elapsed() < LIMIT, "the end: {end:?}, the result: {result:?}");
            match client.poll(Duration::from_millis(100)) {
                Ok(Some(Event::Result(text))) => result = Some(text),
                Ok(_) => {}
                Err(error) => end = end.or(Some(error)),
            }
        }
        assert_eq!((result.as_deref(), player.join().expect("no panic").passes), (Some("lit"), 1));
        assert!(end.is_some_and(|end| end.to_string().contains("the run has ended")));
    });
}

activation_tree! {
    /// Another robot.
    struct Other { root: Counter, cycle_hz: 100, tunable, components: [Counter] }
}

impl Robot for Other {
    type Sensors<'a> = f32;
    type Command = f32;
    type Error = std::convert::Infallible;

    fn sense(&mut self, _: &f32) -> Result<(), Self::Error> {
        Ok(())
    }

    fn act(&mut self) -> f32 {
        0.0
    }
}

#[test]
fn recording_of_another_tree_is_not_played() {
    let file = Temporary::new("played-other.mcap", &recorded(3));
    let address = Address::Memory(Memory::default());
    let other = |_: &Header| Ok(Box::new(Other::new()));
    let refused = play(&options(&file.0, &address), other, |_| Ok(()), || true).expect_err("another tree").what;
    assert!(
        refused.contains("another activation tree, so it is not played") && refused.contains("Blinker"),
        "{refused}"
    );
}
