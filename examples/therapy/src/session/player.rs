//! The component that plays a session.

mod wish;

use bica::prelude::*;
use bica_motion::robot::Light;

use self::wish::{Wish, end};
use super::{Lamp, Movement, Plan, Signal, Step, Task, Until};
use crate::body::{Lights, Motors, Mover, Sound, Walk};
use crate::exercise::ExerciseCheck;
use crate::input::{Guard, PatientPose, Signals, Trouble};

/// Maximum number of steps without a wait in one run.
const AT_ONCE: usize = 16;
/// Time for which the chest button must be pressed to continue after a stop, s.
const EXPRESS: f32 = 2.0;

/// Plays a session. Whatever happens, a stop ends movement, sound and speech, and only an express wish goes on.
#[derive(Debug)]
pub struct Session {
    pub(crate) plan: Plan,
    /// The newest request, and the request that this run processes. A request that cannot be granted at once is
    /// dropped, so nothing continues later by itself.
    wish: Option<Wish>,
    heard: Option<Wish>,
    /// Time in the current wait or exercise, s.
    waited: f32,
    /// Time without a new skeleton, s, and the number of the newest skeleton.
    unseen: (f32, u32),
    /// Factor on tempo and number of repetitions.
    ease: f32,
    /// Movement of which the check has examples, or is learning them.
    learnt: Option<Movement>,
}

#[component(hz = 100, budget_us = 20)]
impl Session {
    pub(crate) const fn new() -> Self {
        Self { plan: Plan::new(), wish: None, heard: None, waited: 0.0, unseen: (0.0, 0), ease: 1.0, learnt: None }
    }

    /// Waits for the start.
    #[state(initial)]
    fn ready(&mut self, _mover: &mut Mover, _walk: &mut Walk, _sound: &mut Sound) {
        self.hear();
    }

    /// Does the steps up to the next wait.
    #[state]
    fn running(
        &mut self,
        mover: &mut Mover,
        walk: &mut Walk,
        sound: &mut Sound,
        lights: &mut Lights,
        motors: &mut Motors,
    ) {
        self.hear();
        (self.waited, self.unseen.0) = (0.0, 0.0);
        for _ in 0..AT_ONCE {
            let Some(step) = self.plan.step() else { return };
            match step {
                // Raised arms could unbalance the walk.
                Step::Move(..) if walk.is_walking() => return walk.halt(),
                Step::Move(movement, tempo) => mover.begin(movement, tempo * self.ease, 0.0),
                Step::Speak(clip) => sound.speech = Some((clip, self.plan.seconds(clip))),
                Step::Play(clip) => sound.music = Some((clip, self.plan.seconds(clip))),
                Step::Volume(volume) => sound.set_volume(volume),
                Step::Light(lamp, light) => lights.set(lamp, light),
                Step::Walk(way) => {
                    mover.rest();
                    walk.begin(way);
                }
                Step::Stop(task) => end(task, mover, walk, sound),
                Step::Stiffness(stiff) => motors.soften(!stiff),
                Step::Wait(..) | Step::Exercise { .. } => return,
                // Jumps are the plan's.
                Step::GoTo(_) | Step::Again { .. } => {}
            }
            self.plan.advance();
        }
    }

    /// Waits as the step says.
    #[state]
    fn waiting(&mut self, time: &Time, _mover: &mut Mover, _walk: &mut Walk, _sound: &mut Sound) {
        self.hear();
        self.waited += time.dt();
    }

    /// Shows a movement and watches the person.
    #[state]
    fn exercising(
        &mut self,
        time: &Time,
        mover: &mut Mover,
        _check: &mut ExerciseCheck,
        pose: &PatientPose,
        walk: &mut Walk,
        _sound: &mut Sound,
    ) {
        self.hear();
        self.waited += time.dt();
        self.unseen.0 += time.dt();
        if self.unseen.1 != pose.number {
            self.unseen = (0.0, pose.number);
        }
        walk.halt();
        if let Some(Step::Exercise { movement, hold, .. }) = self.plan.step()
            && !mover.is_running()
            && !walk.is_walking()
        {
            mover.begin(movement, self.ease, hold);
        }
    }

    /// Rests with the arms down until somebody lets it go on.
    #[state]
    fn paused(&mut self) {
        self.hear();
    }

    /// Stands still until somebody expressly lets it go on.
    #[state]
    fn stopped(&mut self) {
        self.hear();
    }

    /// The session is over.
    #[state]
    fn finished(&mut self, _mover: &mut Mover, _walk: &mut Walk, _sound: &mut Sound) {
        self.hear();
    }

    /// A person stops the session: by the page, or by a bumper that the session does not wait for.
    #[transition(* -> stopped)]
    fn is_stopped(&self, signals: &Signals) -> bool {
        let bumper = [Signal::Left, Signal::Right].into_iter();
        let bumper = bumper.filter(|signal| self.awaited() != Some(*signal)).any(|signal| signals.begins(signal));
        self.heard == Some(Wish::Stop) || bumper
    }

    /// A trouble pauses the session; a fall stops it.
    #[transition(* -> stopped)]
    fn has_fallen(&self, guard: &Guard) -> bool {
        guard.trouble() == Some(Trouble::Fallen)
    }

    #[transition(running | waiting | exercising -> paused)]
    fn is_paused(&self, signals: &Signals, guard: &Guard) -> bool {
        let pressed = self.awaited() != Some(Signal::Chest) && signals.begins(Signal::Chest);
        self.heard == Some(Wish::Pause) || pressed || guard.trouble().is_some()
    }

    /// A person goes to another step; a stopped session stays stopped.
    #[transition(waiting | exercising -> running)]
    fn goes_to(&self) -> bool {
        matches!(self.heard, Some(Wish::GoTo(_)))
    }

    #[transition(ready -> running)]
    fn is_started(&self, signals: &Signals) -> bool {
        self.plan.loaded && (self.heard == Some(Wish::Start) || signals.begins(Signal::Chest))
    }

    #[transition(paused -> running)]
    fn goes_on(&self, signals: &Signals, guard: &Guard) -> bool {
        let wished = self.heard == Some(Wish::GoOn) || signals.begins(Signal::Chest);
        wished && guard.trouble().is_none()
    }

    #[transition(stopped -> running)]
    fn goes_on_after_stop(&self, signals: &Signals, guard: &Guard, walk: &Walk) -> bool {
        let wished = self.heard == Some(Wish::GoOn) || signals.chest > EXPRESS;
        wished && guard.trouble().is_none() && self.plan.loaded && !walk.is_walking()
    }

    #[transition(running -> finished)]
    fn is_over(&self) -> bool {
        self.plan.step().is_none()
    }

    #[transition(running -> waiting)]
    fn must_wait(&self) -> bool {
        matches!(self.plan.step(), Some(Step::Wait(..)))
    }

    #[transition(running -> exercising)]
    fn must_watch(&self) -> bool {
        matches!(self.plan.step(), Some(Step::Exercise { .. }))
    }

    #[transition(waiting -> running)]
    fn has_waited(&self, mover: &Mover, walk: &Walk, sound: &Sound, signals: &Signals) -> bool {
        let Some(Step::Wait(until, limit)) = self.plan.step() else { return true };
        self.waited >= limit
            || match until {
                Until::Time => false,
                Until::Ends(task) => {
                    let (speaks, plays) = (sound.speech.is_some(), sound.music.is_some());
                    let moves = [(Task::Movement, mover.is_running()), (Task::Walk, walk.is_walking())];
                    let sounds = [(Task::Speech, speaks), (Task::Music, plays)];
                    !moves.into_iter().chain(sounds).any(|(one, runs)| runs && task.has(one))
                }
                Until::Signal(signal) => signals.begins(signal),
            }
    }

    #[transition(exercising -> running)]
    fn has_exercised(&self, check: &ExerciseCheck) -> bool {
        self.result(check).is_some()
    }

    #[entry(exercising)]
    fn begin_exercise(&mut self, check: &mut ExerciseCheck) {
        let Some(Step::Exercise { movement, .. }) = self.plan.step() else { return };
        if self.learnt.replace(movement) == Some(movement) { check.restart() } else { check.learn() }
    }

    #[exit(waiting)]
    fn end_wait(&mut self, mover: &Mover, walk: &Walk, sound: &Sound, signals: &Signals) {
        if self.heard.is_none() && self.has_waited(mover, walk, sound, signals) {
            self.plan.pass(None);
        }
    }

    #[exit(exercising)]
    fn end_exercise(&mut self, check: &ExerciseCheck, mover: &mut Mover) {
        if self.heard.is_none()
            && let Some(result) = self.result(check)
        {
            self.plan.pass(Some(result));
            mover.rest();
        }
    }

    #[entry(paused)]
    fn pause_all(&mut self, mover: &mut Mover, walk: &mut Walk, sound: &mut Sound, lights: &mut Lights) {
        end(Task::All, mover, walk, sound);
        mover.rest();
        lights.set(Lamp::Chest, Light(1.0, 0.6, 0.0));
    }

    #[entry(stopped)]
    fn stop_all(
        &mut self,
        mover: &mut Mover,
        walk: &mut Walk,
        sound: &mut Sound,
        lights: &mut Lights,
        guard: &mut Guard,
    ) {
        end(Task::All, mover, walk, sound);
        // A stop ends control, so no page can show any more that it is there.
        guard.page_closes();
        walk.freeze();
        lights.set(Lamp::Chest, Light(1.0, 0.0, 0.0));
    }

    #[exit(paused)]
    fn repeat_begun(&mut self) {
        self.plan.go_back();
    }

    /// A movement that was stopped is not continued; what was begun begins anew.
    #[exit(stopped)]
    fn leave_stop(&mut self, mover: &mut Mover) {
        mover.rest();
        self.plan.go_back();
    }

    /// Starts the session.
    #[modulation]
    pub(crate) const fn start(&mut self) {
        self.ask(Wish::Start);
    }

    /// Pauses the session: the arms go down.
    #[modulation]
    pub(crate) const fn pause(&mut self) {
        self.ask(Wish::Pause);
    }

    /// Lets a paused or stopped session go on, from what it did when it was interrupted.
    #[modulation]
    pub(crate) const fn go_on(&mut self) {
        self.ask(Wish::GoOn);
    }

    /// Stops the session: nothing moves or sounds.
    #[modulation(stop)]
    pub(crate) const fn stop(&mut self) {
        self.wish = Some(Wish::Stop);
    }

    /// Goes on with what follows the present wait or exercise.
    #[modulation]
    pub(crate) fn next(&mut self) {
        self.ask(Wish::GoTo(self.plan.next()));
    }

    /// Goes back to what was before the present wait or exercise.
    #[modulation]
    pub(crate) fn previous(&mut self) {
        self.ask(Wish::GoTo(self.plan.previous()));
    }

    /// Does the present steps again.
    #[modulation]
    pub(crate) const fn repeat(&mut self) {
        self.ask(Wish::GoTo(self.plan.begun()));
    }

    /// Goes to a step, from 0.
    #[modulation]
    pub(crate) const fn go_to(&mut self, #[range(0..=500)] step: u32) {
        self.ask(Wish::GoTo(step as u16));
    }

    /// Makes tempo and number of repetitions less, by a fifth.
    #[modulation]
    pub(crate) fn easier(&mut self) {
        self.ease = (0.8 * self.ease).max(0.4);
    }

    /// Gives tempo and number of repetitions back, by a fifth of what is left.
    #[modulation]
    pub(crate) fn harder(&mut self) {
        self.ease = (1.25 * self.ease).min(1.0);
    }

    /// Share of tempo and repetitions that is left after what was made easier.
    #[output]
    pub(crate) const fn ease(&self) -> f32 {
        self.ease
    }

    /// Time in the present wait or exercise, s.
    #[output(unit = "s")]
    pub(crate) const fn waited(&self) -> f32 {
        self.waited
    }

    /// Most time of the present wait or exercise, s; 0 if the present step is none.
    #[output(unit = "s")]
    pub(crate) fn limit(&self) -> f32 {
        if let Some(Step::Wait(_, limit) | Step::Exercise { limit, .. }) = self.plan.step() { limit } else { 0.0 }
    }

    /// Number of the present step, from 0.
    #[output]
    pub(crate) const fn at(&self) -> u16 {
        self.plan.at()
    }
}
