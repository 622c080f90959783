//! Tests of monitors that operate the robot.

use std::path::Path;
use std::time::Duration;

use bica::{ComponentId, Tree};
use bica_link::{Answered, Client, Error, Event};
use bica_player::motion::Head;
use bica_player::tunable::Forward;
use bica_wire::FromMonitor;
use bica_wire::message::{Change, Hold, LeaseAction, RefusalCode, Request, Setting, Value};

use super::body::{Body, CYCLE_US, Cycle, Received, compare_with_host, first_difference};
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
    let (component, info) = client.description().info("Colours.is_tuned")?;
    client.watch_info(component, info, 10)?;
    loop {
        match client.poll(super::PATIENCE)? {
            Some(Event::Info { value: Some(value), .. }) if value == [1] => break,
            Some(_) => {}
            None => return Ok(false),
        }
    }
    client.watch_info(component, info, 0)?;
    Ok(true)
}

pub(super) fn refusals(image: &Path) -> Outcome {
    let body = Body::start(image)?;
    let mut client = attach(body.monitors)?;
    let change = set(&client, "Head.stiffness", Value::F32(0.4))?;
    expect_refused(&client.request(change.borrow()), RefusalCode::NoLease, "lease")?;
    client.acquire(false)?;
    let lease = client.lease().lease;
    let stale = client.send_request_with(change.borrow(), lease.wrapping_sub(1), u64::MAX)?;
    expect_refused(&client.answer(stale), RefusalCode::NoLease, "lease")?;
    let expired = client.send_request_with(change.borrow(), lease, 0)?;
    expect_refused(&client.answer(expired), RefusalCode::Expired, "expiry")?;
    let outside = set(&client, "Head.stiffness", Value::F32(7.0))?;
    expect_refused(&client.request(outside.borrow()), RefusalCode::Tree, "`Head.stiffness`: outside the range")?;
    let kind = set(&client, "Head.stiffness", Value::Bool(true))?;
    expect_refused(&client.request(kind.borrow()), RefusalCode::Tree, "another kind")?;
    let Change::Params(mut batch) = change else { return Err("no batch".into()) };
    let _ = batch.push(Setting::new(ComponentId::new(999), 0, Value::F32(0.0)));
    expect_refused(&client.request(bica::runner::Request::Params(&batch)), RefusalCode::Tree, "no such component")?;
    let hold = Change::Hold { component: ComponentId::new(999), hold: Hold::Active };
    expect_refused(&client.request(hold.borrow()), RefusalCode::Tree, "no such component")?;
    // Sends many requests at once: each must be answered.
    let modulate = Change::Modulate { component: head(), modulation: 0, arguments: [].into_iter().collect() };
    let numbers: Vec<_> = (0..100).map(|_| client.send_request(modulate.borrow())).collect::<Result<_, _>>()?;
    for number in numbers {
        expect_refused(&client.answer(number), RefusalCode::Tree, "arguments")?;
    }
    compare_with_host(&body.stop()?, &[])
}

fn expect_refused(answer: &Result<Answered, Error>, expected: RefusalCode, part: &str) -> Outcome {
    match answer {
        Err(Error::Refused { code, text, .. }) if *code == expected && text.contains(part) => Ok(()),
        other => Err(format!("{other:?}, expected a refusal {expected:?} with `{part}`").into()),
    }
}

/// Sends a lease action on the body's line. Waits for a lease with this value of `yours`, and returns its number.
fn lease(body: &Body, action: LeaseAction, yours: bool) -> Result<u64, Box<dyn std::error::Error>> {
    body.send(FromMonitor::Lease(action))?;
    body.receive(|message| match message {
        Received::Lease(lease) if lease.owned && lease.yours == yours => Some(lease.lease),
        _ => None,
    })
}

pub(super) fn two(image: &Path) -> Outcome {
    let body = Body::start(image)?;
    let mut client = attach(body.monitors)?;
    client.acquire(false)?;
    let first = client.lease().lease;
    let hold = Change::Hold { component: head(), hold: Hold::Active };
    let held = client.request(hold.borrow())?.cycle;
    body.send(FromMonitor::Attach)?;
    expect_eq(&lease(&body, LeaseAction::Acquire, false)?, &0)?;
    let request = |number, lease| {
        let change = Change::Hold { component: head(), hold: Hold::Tree };
        FromMonitor::Request(Request { number, lease, expires_us: u64::MAX, change })
    };
    let answer = |wanted| {
        body.receive(move |message| match message {
            Received::Answer(number, done) if number == wanted => Some(done),
            _ => None,
        })
    };
    body.send(request(1, first))?;
    expect_eq(&answer(1)?, &false)?;
    let second = lease(&body, LeaseAction::Take, true)?;
    expect(second != first, "a new number")?;
    while client.lease().yours {
        client.poll(Duration::from_millis(100))?;
    }
    expect_refused(&client.request(hold.borrow()), RefusalCode::NoLease, "lease")?;
    expect(client.acquire(false).is_err(), "the lease is owned")?;
    body.wait_for(GUARDED.max(held) as usize + 5)?;
    let before = body.count() as u64;
    body.send(request(2, second))?;
    expect_eq(&answer(2)?, &true)?;
    let count = body.count();
    body.wait_for(count + 5)?;
    let cycles = body.stop()?;
    // The hold must end by the request, not by the change of the lease's owner.
    let ended = head_is(false, &cycles, GUARDED.max(held))?;
    expect((before..before + 5).contains(&ended), &format!("the hold ended in {ended}, requested after {before}"))?;
    let release = Change::Hold { component: head(), hold: Hold::Tree };
    compare_with_host(&cycles, &[(held, hold), (ended, release)])
}
