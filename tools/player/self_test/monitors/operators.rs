//! Tests of monitors that operate the robot.

use std::path::Path;

use bica::{ComponentId, Tree};
use bica_link::{Answered, Client, Event};
use bica_player::motion::Head;
use bica_player::tunable::Forward;
use bica_wire::message::{Change, Hold, Setting, Value};

use super::body::{Body, CYCLE_US, Cycle, compare_with_host, first_difference};
use super::{Outcome, attach, expect};
use crate::session::expect_eq;

/// Silence of the operator that ends the lease, and longest time between its last message and the last answer, both in cycles.
const SILENCE: u64 = 3_000_000 / CYCLE_US;
const LATE: u64 = 150;

/// Returns a change of one parameter.
fn set(client: &Client, path: &str, value: Value) -> Result<Change, Box<dyn std::error::Error>> {
    let (component, index) = client.description().param(path)?;
    let setting = Setting::new(ComponentId::new(component), index as u16, value);
    Ok(Change::Params([setting].into_iter().collect()))
}

fn head() -> ComponentId {
    Forward::id::<Head>()
}

/// Number of cycles after which a motionless body counts as a fault. From then on the tree does not activate the head.
const GUARDED: u64 = 110;

/// Returns the first cycle from `from` on in which the head is active, or latent.
fn head_is(active: bool, cycles: &[Cycle], from: u64) -> Result<u64, Box<dyn std::error::Error>> {
    let found =
        (from as usize..cycles.len()).find(|cycle| (cycles[*cycle].active >> head().index() & 1 == 1) == active);
    Ok(found.ok_or_else(|| format!("the head's activity is never {active} from cycle {from} on"))? as u64)
}

pub(super) fn requests(image: &Path) -> Outcome {
    let body = Body::start(image)?;
    let mut client = attach(body.monitors)?;
    client.acquire(false)?;
    let stiffness = set(&client, "Head.stiffness", Value::F32(0.4))?;
    let orange = set(&client, "Colours.orange_hue_to", Value::U32(150))?;
    let look = client.description().modulation("Head.look_at")?;
    let count = client.description().components[look.0].modulations[look.1].arguments.len();
    let arguments = (0..count).map(|_| Value::F32(0.2)).collect();
    let rate =
        Change::Rate { component: ComponentId::new(client.description().component("LookAround")?), hz: Some(20.0) };
    let hold = Change::Hold { component: head(), hold: Hold::Active };
    let modulate = Change::Modulate { component: ComponentId::new(look.0), modulation: look.1 as u16, arguments };
    let mut changes = Vec::new();
    for change in [stiffness, orange, rate.clone(), modulate, hold] {
        let Answered { cycle, arrived, values, .. } = client.request(change.borrow())?;
        match &change {
            Change::Params(batch) => expect_eq(&values, &vec![batch[0].value])?,
            Change::Rate { hz: Some(hz), .. } => expect_eq(&values, &vec![Value::F32(*hz)])?,
            _ => expect(values.is_empty(), "no values")?,
        }
        expect(arrived <= cycle && cycle <= arrived + 1, "in force at most two cycles after its arrival")?;
        changes.push((cycle, change));
    }
    expect_eq(&tuned_colours(&mut client)?, &true)?;
    let last = client.request(bica::runner::Request::Rate { component: head(), hz: None })?.cycle;
    changes.push((last, Change::Rate { component: head(), hz: None }));
    // From here on the operator is silent.
    body.wait_for((last + SILENCE + 2 * LATE) as usize)?;
    let cycles = body.stop()?;
    let ended = head_is(false, &cycles, GUARDED.max(changes[4].0))?;
    expect(
        (last..=last + SILENCE + LATE).contains(&ended),
        &format!("silent since {last}, the hold ended in {ended}"),
    )?;
    expect(ended > last + SILENCE - 2, &format!("silent since {last}, the hold ended in {ended}, too early"))?;
    let lasting = changes.clone();
    changes.push((ended, Change::Hold { component: head(), hold: Hold::Tree }));
    let Change::Rate { component, .. } = rate else { return Err("no rate".into()) };
    changes.push((ended, Change::Rate { component, hz: None }));
    // A monitor that attached late sets the parameter of a latent head: the parameter acts when the head is held active.
    let acts = head_is(true, &cycles, changes[0].0)?;
    expect(first_difference(&cycles, &[])? == Some(acts as usize), "the parameter acts in the head's first cycle")?;
    expect(first_difference(&cycles, &lasting)? == Some(ended as usize), "the hold's end acts in its cycle")?;
    compare_with_host(&cycles, &changes)
}

/// Waits until the table of the adjusted colours is in use.
fn tuned_colours(client: &mut Client) -> Result<bool, Box<dyn std::error::Error>> {
    let (component, output) = client.description().output("Colours.is_tuned")?;
    client.watch_output(component, output, 10)?;
    loop {
        match client.poll(super::PATIENCE)? {
            Some(Event::Output { value: Some(value), .. }) if value == [1] => break,
            Some(_) => {}
            None => return Ok(false),
        }
    }
    client.watch_output(component, output, 0)?;
    Ok(true)
}
