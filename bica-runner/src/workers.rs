//! Jobs on threads of the computer, and jobs that wait for a replay.

use std::boxed::Box;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::vec::Vec;

use bica_core::work::{Visitor, WorkOf, WorkSlot, slot, visit, visit_at};
use bica_core::{ComponentId, Has, Instant, Tree};

use crate::jobs::Jobs;

/// Puts the result of a job into its tree.
type Put<T> = Box<dyn FnOnce(&T) + Send>;

/// Number of a job of a component.
type Ticket = (ComponentId, u32);

/// Job that was taken from its tree.
struct Job<T> {
    ticket: Ticket,
    due: Instant,
    run: Box<dyn FnOnce() -> Put<T> + Send>,
}

struct Take<T>(Vec<Job<T>>);

impl<T: Tree> Visitor<T> for Take<T> {
    fn visit<C: 'static>(&mut self, component: ComponentId, slot: &WorkOf<T, C>)
    where
        T: Has<C>,
    {
        let Some(job) = slot.take() else { return };
        let (number, state) = (job.ticket, job.state);
        let run = move || -> Put<T> {
            let output = catch_unwind(AssertUnwindSafe(|| WorkOf::<T, C>::finish(state))).ok();
            Box::new(move |tree| self::slot::<T, C>(tree).put(number, output))
        };
        self.0.push(Job { ticket: (component, number), due: job.due, run: Box::new(run) });
    }
}

/// Takes all jobs that wait.
fn take<T: Tree>(tree: &T) -> Vec<Job<T>> {
    let mut taken = Take(Vec::new());
    visit(tree, &mut taken);
    taken.0
}

/// Whether the job of a number is awaited.
struct Awaited(u32, bool);

impl<T: Tree> Visitor<T> for Awaited {
    fn visit<C: 'static>(&mut self, _: ComponentId, slot: &WorkOf<T, C>)
    where
        T: Has<C>,
    {
        self.1 = slot.is_awaited(self.0);
    }
}

fn is_awaited<T: Tree>(tree: &T, (component, number): Ticket) -> bool {
    let mut awaited = Awaited(number, false);
    visit_at(tree, component, &mut awaited);
    awaited.1
}

/// When the results of [`Workers`] arrive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// In the first cycle at or after the due time, before which the loop waits for the result. The run is then the same on any computer
    /// with any number of threads.
    Simulated,
    /// In the first cycle after the job has ended.
    RealTime,
}

/// Threads that run the jobs of a robot's components beside its loop. They are started with the first job.
///
/// A job that panics has no result; its panic is printed as that of any thread. A job that its component has given up runs to its end, and
/// its result is dropped.
pub struct Workers<T> {
    threads: usize,
    pace: Pace,
    notice: Option<Notice>,
    pool: Option<Pool<T>>,
    /// Jobs that have not ended.
    away: Vec<(Ticket, Instant)>,
    /// Results that are not in the tree yet, with their due times.
    ended: Vec<(Instant, Put<T>)>,
}

/// Function that a thread calls before a job of a component.
type Notice = Arc<dyn Fn(ComponentId) + Send + Sync>;

/// The threads, and the channel by which results come back.
struct Pool<T> {
    jobs: Sender<Job<T>>,
    ended: Receiver<(Ticket, Put<T>)>,
}

impl<T: Tree> Workers<T> {
    /// Creates workers with this number of threads, at least one.
    #[must_use]
    pub const fn new(threads: usize, pace: Pace) -> Self {
        Self { threads, pace, notice: None, pool: None, away: Vec::new(), ended: Vec::new() }
    }

    /// Sets a function that each thread calls before it runs a job of a component.
    #[must_use]
    pub fn announcing(self, notice: impl Fn(ComponentId) + Send + Sync + 'static) -> Self {
        Self { notice: Some(Arc::new(notice)), ..self }
    }

    /// Takes over one result, for which it waits if `waits`; returns whether there was one.
    fn receive(&mut self, waits: bool) -> bool {
        let Some(pool) = &self.pool else { return false };
        let ended = if waits { pool.ended.recv().ok() } else { pool.ended.try_recv().ok() };
        let Some((ticket, put)) = ended else { return false };
        let known = self.away.iter().position(|(other, _)| *other == ticket);
        if let Some((_, due)) = known.map(|place| self.away.swap_remove(place)) {
            self.ended.push((due, put));
        }
        true
    }
}

impl<T: Tree> Jobs<T> for Workers<T> {
    fn deliver(&mut self, now: Instant, tree: &T) {
        while self.receive(false) {}
        let waits = self.pace == Pace::Simulated;
        while waits && self.away.iter().any(|(ticket, due)| *due <= now && is_awaited(tree, *ticket)) {
            self.receive(true);
        }
        for (_, put) in self.ended.extract_if(.., |(due, _)| !waits || *due <= now) {
            put(tree);
        }
    }

    fn collect(&mut self, tree: &T) {
        for job in take(tree) {
            self.away.push((job.ticket, job.due));
            // It fails only if a thread could not be started; the job is then late.
            let _ = self.pool.get_or_insert_with(|| Pool::start(self.threads, self.notice.as_ref())).jobs.send(job);
        }
    }
}

impl<T: Tree> Pool<T> {
    fn start(threads: usize, notice: Option<&Notice>) -> Self {
        let ((jobs, waiting), (done, ended)) = (channel::<Job<T>>(), channel());
        let waiting = Arc::new(Mutex::new(waiting));
        for _ in 0..threads.max(1) {
            let (waiting, done, notice) = (Arc::clone(&waiting), done.clone(), notice.cloned());
            let next = move || waiting.lock().unwrap_or_else(PoisonError::into_inner).recv();
            let work = move || {
                while let Ok(job) = next() {
                    if let Some(notice) = &notice {
                        notice(job.ticket.0);
                    }
                    let put = (job.run)();
                    if done.send((job.ticket, put)).is_err() {
                        break;
                    }
                }
            };
            thread::Builder::new().name("work".into()).spawn(work).expect("the system can start a thread");
        }
        Self { jobs, ended }
    }
}

/// Jobs that wait until they are to end: in a replay, before the cycle in which they ended in the recorded run.
pub struct HeldJobs<T>(Vec<Job<T>>);

impl<T: Tree> HeldJobs<T> {
    /// Creates an empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    /// Runs the job of a component and puts its result into the tree: it is there in the next cycle. Returns whether the component has a
    /// job.
    pub fn end(&mut self, tree: &T, component: ComponentId) -> bool {
        self.0.retain(|job| is_awaited(tree, job.ticket));
        let place = self.0.iter().position(|job| job.ticket.0 == component);
        place.map(|place| (self.0.swap_remove(place).run)()(tree)).is_some()
    }
}

impl<T: Tree> Default for HeldJobs<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Tree> Jobs<T> for HeldJobs<T> {
    fn collect(&mut self, tree: &T) {
        self.0.extend(take(tree));
    }
}
