//! The store of a tree's components, and how a step borrows several of them at once.
//!
//! This is the only unsafe code of the framework. [`Store`] owns the components, each in a [`Slot`]. Both are declared in the
//! parent module, whose traits name them; it reads and writes none of their fields. There are two ways to use the store:
//!
//! - While no cycle is in progress, through ordinary borrows: [`Store::get`] reads through `&Store`, [`Store::get_mut`]
//!   writes through `&mut Store`.
//! - During a cycle through its [`ExclusiveStore`], which borrows the store exclusively for as long as it exists. So
//!   there is one at a time, and nothing else reaches the components.
//!
//! [`ExclusiveStore::borrow`] returns references to several components together, which live as long as the exclusive
//! store itself is borrowed mutably. So nothing is borrowed twice at a time: not by a visit inside a step, because a step
//! has no exclusive store; not by keeping a reference, because the exclusive store cannot be used before it ends. What
//! remains is that the components of one set are distinct, and that the slots are the store's own:
//!
//! - Every [`BorrowSet`] lists its accesses, and `borrow` asserts at compile time that no two are to one place, unless both
//!   read it: shared references may overlap. One type
//!   has one index in a tree, because a type implements `Has` once for a tree. So different indices are different types,
//!   hence different slots: a `&Slot<A, _>` and a `&Slot<B, _>` cannot overlap unless one lies inside the other's component,
//!   which only a borrow could reach.
//! - `Has` is implemented by generated code without `unsafe`, so it is not trusted: [`slot_in`] asserts that the slot
//!   lies inside the store. For a field that is a comparison of constants and leaves no code.
#![expect(
    unsafe_code,
    reason = "borrows several distinct components of one tree at once; argued above and at each block"
)]

use core::cell::UnsafeCell;
use core::marker::PhantomData;
use core::mem::ManuallyDrop;
use core::ptr;

use super::{ExclusiveStore, Has, Layout, ParamsOf, Slot, Store, WorkOf, visits_at_rate};
use crate::component::Component;
use crate::rate::{Period, Rate};
use crate::tree::component_state::ComponentState;
use crate::tree::cycle_state::CycleState;
use crate::work::WorkSlot;

impl<C: 'static, S, W: WorkSlot> Slot<C, S, W> {
    /// Holds `value` in tree `T`, with its parameters, at its declared rate and never active yet.
    pub const fn with<T: Has<C>>(value: C, params: S) -> Self {
        Self {
            state: ComponentState::new(),
            rate: UnsafeCell::new(Rate::at(<T::Member as Component>::HZ)),
            value: UnsafeCell::new(value),
            params: ManuallyDrop::new(params),
            work: ManuallyDrop::new(W::EMPTY),
        }
    }

    /// The place of the jobs.
    pub fn work(&self) -> &W {
        &self.work
    }

    /// The parameters.
    #[inline]
    pub fn params(&self) -> &S {
        &self.params
    }

    /// The parameters, between two cycles.
    pub fn params_mut(&mut self) -> &mut S {
        &mut self.params
    }

    /// State of the component; it lies in no `UnsafeCell` and is never borrowed mutably.
    pub const fn state(&self) -> &ComponentState {
        &self.state
    }

    /// The rate, which is about to be written.
    #[inline]
    fn written_rate<T: Has<C>>(&self) -> *mut Rate<C> {
        if !const { visits_at_rate::<T, C>() } {
            self.state.activation().read_period();
        }
        self.rate.get()
    }
}

/// Returns the slot of `C`, which lies inside `slots`; otherwise panics.
#[inline]
fn slot_in<T: Has<C>, C: 'static>(slots: &T::Slots) -> &Slot<C, T::Stored, WorkOf<T, C>> {
    let slot = T::slot(slots);
    let offset = ptr::from_ref(slot).addr().wrapping_sub(ptr::from_ref(slots).addr());
    let is_inside = offset.saturating_add(size_of::<Slot<C, T::Stored, WorkOf<T, C>>>()) <= size_of::<T::Slots>();
    assert!(is_inside, "`Has::slot` returned a slot outside this tree's store");
    slot
}

// SAFETY: nothing is `Shared`, so this never applies. It replaces the automatic impl, whose absence the compiler explains
// cell by cell.
unsafe impl<T: Layout> Sync for Store<T> where (): Shared<T> {}

/// Tree `T` can be used by several threads. No tree can.
#[diagnostic::on_unimplemented(
    message = "activation tree `{T}` cannot be shared: one owner ticks it",
    label = "`{T}` is not `Sync`",
    note = "for a `static`, write `static ROBOT: ConstStaticCell<{T}> = ConstStaticCell::new({T}::new());` with the \
            crate `static_cell`, and take it once with `ROBOT.take()`"
)]
pub(crate) trait Shared<T> {}

impl<T: Layout> Store<T> {
    /// Takes the slots.
    pub(crate) const fn new(slots: T::Slots) -> Self {
        let cycle_state = CycleState::new(const { T::PLANS.exist() });
        Self { cycle_state, slots }
    }

    /// What the components share; it is never borrowed mutably.
    #[inline]
    pub(crate) const fn cycle_state(&self) -> &CycleState {
        &self.cycle_state
    }

    /// The slots; their components can be reached only through the store.
    pub(crate) const fn slots(&self) -> &T::Slots {
        &self.slots
    }

    /// Reads a component.
    pub(crate) fn get<C: 'static>(&self) -> &C
    where
        T: Has<C>,
    {
        let value = slot_in::<T, C>(&self.slots).value.get();
        // SAFETY: the slot is inside this store. Only `get_mut`, `rate_mut`, `params_mut` and `ExclusiveStore::borrow` make
        // exclusive references to what is in it. All of them need an exclusive borrow of the store, so none of their references can
        // exist while `self` is borrowed.
        unsafe { &*value }
    }

    /// Writes a component.
    pub(crate) fn get_mut<C: 'static>(&mut self) -> &mut C
    where
        T: Has<C>,
    {
        let value = slot_in::<T, C>(&self.slots).value.get();
        // SAFETY: the slot is inside this store, which is borrowed exclusively for as long as the reference lives.
        unsafe { &mut *value }
    }

    /// Reads the rate of a component.
    #[inline]
    pub(crate) fn rate<C: 'static>(&self) -> &Rate<C>
    where
        T: Has<C>,
    {
        let rate = slot_in::<T, C>(&self.slots).rate.get();
        // SAFETY: as in `get`.
        unsafe { &*rate }
    }

    /// Writes the rate of a component.
    pub(crate) fn rate_mut<C: 'static>(&mut self) -> &mut Rate<C>
    where
        T: Has<C>,
    {
        self.leave_steady();
        let rate = slot_in::<T, C>(&self.slots).written_rate::<T>();
        // SAFETY: as in `get_mut`.
        unsafe { &mut *rate }
    }

    /// Reads the parameters of a component.
    #[inline]
    pub(crate) fn params<C: 'static>(&self) -> &ParamsOf<T, C>
    where
        T: Has<C>,
    {
        T::params(&self.slots)
    }

    /// Writes the parameters of a component; `None` if they are constants.
    pub(crate) fn params_mut<C: 'static>(&mut self) -> Option<&mut ParamsOf<T, C>>
    where
        T: Has<C>,
    {
        T::params_mut(&mut self.slots)
    }

    /// Borrows the store for one cycle.
    pub(crate) const fn open(&mut self) -> ExclusiveStore<'_, T> {
        ExclusiveStore { store: self, exclusive: PhantomData }
    }
}

impl<'t, T: Layout> ExclusiveStore<'t, T> {
    /// What the components share.
    #[inline]
    pub(crate) const fn cycle_state(&self) -> &'t CycleState {
        self.store.cycle_state()
    }

    /// State of the component of that index, if there is one.
    pub(crate) fn state_at(&self, index: usize) -> Option<&'t ComponentState> {
        T::component_state(&self.store.slots, index)
    }

    /// State of `C`.
    #[inline]
    pub(crate) fn component_state<C: 'static>(&self) -> &'t ComponentState
    where
        T: Has<C>,
    {
        T::slot(&self.store.slots).state()
    }

    /// The slots, through which no component can be reached.
    pub(crate) const fn slots(&self) -> &'t T::Slots {
        &self.store.slots
    }

    /// Parameters of `C`.
    #[inline]
    pub(crate) fn tuned<C: 'static>(&self) -> &'t ParamsOf<T, C>
    where
        T: Has<C>,
    {
        self.store.params::<C>()
    }

    /// The time between two runs of `C`.
    #[inline]
    pub(crate) fn period<C: 'static>(&self) -> &Period
    where
        T: Has<C>,
    {
        self.store.rate::<C>().period()
    }

    /// Borrows the components of `L`.
    #[inline]
    pub(crate) fn borrow<L: BorrowSet<T>>(&mut self) -> L::Borrowed<'_> {
        const { assert!(is_distinct(L::ACCESSES), "{}", TWO_LINKS) };
        // SAFETY: this is the only access to the store, and it is borrowed exclusively for as long as the references
        // live; by the line above no place is accessed twice, unless it is only read.
        unsafe { L::borrow(&self.store.slots) }
    }
}

/// A set of components to borrow together: `()`, a [`Read`], a [`Write`], a [`WriteRate`], or a pair of sets.
///
/// Pairs nest to a balanced tree, so that a large set needs few levels of types.
pub trait BorrowSet<T: Layout>: sealed::Sealed {
    /// The references.
    type Borrowed<'a>;
    /// The places that are borrowed.
    const ACCESSES: &'static Accesses;

    /// Borrows the components.
    ///
    /// # Safety
    ///
    /// As long as the references exist nothing else may refer to the components and rates of `slots`, and no place may
    /// be in the accesses twice, unless it is only read.
    unsafe fn borrow(slots: &T::Slots) -> Self::Borrowed<'_>;
}

/// Borrows `&C`.
pub struct Read<C>(PhantomData<C>);
/// Borrows `&mut C`.
pub struct Write<C>(PhantomData<C>);
/// Borrows `&mut Rate<C>`.
pub struct WriteRate<C>(PhantomData<C>);

/// The places that a set borrows.
pub enum Accesses {
    /// No place.
    None,
    /// The component of that index, which is read.
    Read(usize),
    /// The component of that index, which is written.
    Write(usize),
    /// The rate of the component of that index.
    Rate(usize),
    /// The places of two sets.
    Both(&'static Self, &'static Self),
}

const TWO_LINKS: &str = "two links to one component in one signature";

const fn is_distinct(accesses: &Accesses) -> bool {
    match accesses {
        Accesses::Both(left, right) => is_distinct(left) && is_distinct(right) && are_disjoint(left, right),
        _ => true,
    }
}

const fn are_disjoint(left: &Accesses, right: &Accesses) -> bool {
    match (left, right) {
        (Accesses::Both(first, second), other) | (other, Accesses::Both(first, second)) => {
            are_disjoint(first, other) && are_disjoint(second, other)
        }
        (Accesses::Read(left) | Accesses::Write(left), Accesses::Write(right))
        | (Accesses::Write(left), Accesses::Read(right))
        | (Accesses::Rate(left), Accesses::Rate(right)) => *left != *right,
        _ => true,
    }
}

impl<T: Layout> BorrowSet<T> for () {
    type Borrowed<'a> = ();
    const ACCESSES: &'static Accesses = &Accesses::None;

    #[inline]
    unsafe fn borrow(_: &T::Slots) {}
}

impl<T: Has<C>, C: 'static> BorrowSet<T> for Read<C> {
    type Borrowed<'a> = &'a C;
    const ACCESSES: &'static Accesses = &Accesses::Read(T::INDEX);

    #[inline]
    unsafe fn borrow(slots: &T::Slots) -> &C {
        let value = slot_in::<T, C>(slots).value.get();
        // SAFETY: the slot is inside `slots`, to whose components nothing else refers, and no other part of the set
        // writes it: the caller's promise.
        unsafe { &*value }
    }
}

impl<T: Has<C>, C: 'static> BorrowSet<T> for Write<C> {
    type Borrowed<'a> = &'a mut C;
    const ACCESSES: &'static Accesses = &Accesses::Write(T::INDEX);

    #[inline]
    unsafe fn borrow(slots: &T::Slots) -> &mut C {
        let value = slot_in::<T, C>(slots).value.get();
        // SAFETY: as for `Read`, and no other part of the set reads it.
        unsafe { &mut *value }
    }
}

impl<T: Has<C>, C: 'static> BorrowSet<T> for WriteRate<C> {
    type Borrowed<'a> = &'a mut Rate<C>;
    const ACCESSES: &'static Accesses = &Accesses::Rate(T::INDEX);

    #[inline]
    unsafe fn borrow(slots: &T::Slots) -> &mut Rate<C> {
        let rate = slot_in::<T, C>(slots).written_rate::<T>();
        // SAFETY: as for `Read`; a component and its rate are two cells.
        unsafe { &mut *rate }
    }
}

impl<T: Layout, A: BorrowSet<T>, B: BorrowSet<T>> BorrowSet<T> for (A, B) {
    type Borrowed<'a> = (A::Borrowed<'a>, B::Borrowed<'a>);
    const ACCESSES: &'static Accesses = &Accesses::Both(A::ACCESSES, B::ACCESSES);

    #[inline]
    unsafe fn borrow(slots: &T::Slots) -> Self::Borrowed<'_> {
        // SAFETY: the caller's promise holds for each part, and for what is in both.
        unsafe { (A::borrow(slots), B::borrow(slots)) }
    }
}

mod sealed {
    /// Only this module implements [`BorrowSet`](super::BorrowSet).
    pub trait Sealed {}

    impl Sealed for () {}
    impl<C> Sealed for super::Read<C> {}
    impl<C> Sealed for super::Write<C> {}
    impl<C> Sealed for super::WriteRate<C> {}
    impl<A: Sealed, B: Sealed> Sealed for (A, B) {}
}
