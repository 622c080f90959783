//! Where the components of a tree live, and how a step gets at several of them at once.
//!
//! The only unsafe code of the framework. [`Store`] owns the components, each in a [`Slot`]. It can be used in two ways:
//!
//! - While no cycle is going on, as any owner: [`Store::get`] reads through `&Store`, [`Store::get_mut`] writes through
//!   `&mut Store`.
//! - During a cycle through its [`Key`], which borrows the store exclusively for as long as the key exists. So there is
//!   one key to a store, and nothing else reaches its components.
//!
//! [`Key::lend`] hands out references to several components together, for as long as the key itself is borrowed
//! mutably. So nothing is lent twice at a time: not by a visit inside a step, for a step has no key; not by keeping
//! what was lent, for the key cannot be used before it is given back. What remains is that the components of one loan
//! are distinct, and that the slots are the store's own:
//!
//! - Every [`Loan`] lists the places that it claims, and `lend` asserts at compile time that no two are the same. One
//!   type has one index in a tree, because a type implements `Has` once for a tree. So different indices are different
//!   types, hence different slots: an `&Slot<A>` and an `&Slot<B>` cannot overlap unless one lies inside the other's
//!   component, which nothing but a loan could reach.
//! - `Has` is implemented by generated code without `unsafe`, so it is not trusted: [`place`] asserts that the slot it
//!   names lies inside the store. For a field that is a comparison of constants and leaves no code.
#![expect(
    unsafe_code,
    reason = "lends several distinct components of one tree at once; argued above and at each block"
)]

use core::cell::UnsafeCell;
use core::marker::PhantomData;
use core::ptr;

use crate::clock::Clock;
use crate::component::Component;
use crate::pulse::Pulse;
use crate::rate::Rate;
use crate::tree::{Has, Layout};

/// One component of a tree, with its rate and its clock.
pub struct Slot<C> {
    clock: Clock,
    rate: UnsafeCell<Rate<C>>,
    value: UnsafeCell<C>,
}

impl<C: 'static> Slot<C> {
    /// Holds `value` in tree `T`, at its declared rate and never active yet.
    pub const fn new<T: Has<C>>(value: C) -> Self {
        let rate = Rate::at(<T::Member as Component>::HZ);
        Self { clock: Clock::new(), rate: UnsafeCell::new(rate), value: UnsafeCell::new(value) }
    }

    /// What is remembered of the component; it lies in no cell and is never lent.
    pub const fn clock(&self) -> &Clock {
        &self.clock
    }
}

/// The slot of `C`, which lies inside `slots` or this panics.
#[inline]
fn place<T: Has<C>, C: 'static>(slots: &T::Slots) -> &Slot<C> {
    let slot = T::slot(slots);
    let offset = ptr::from_ref(slot).addr().wrapping_sub(ptr::from_ref(slots).addr());
    assert!(offset.saturating_add(size_of::<Slot<C>>()) <= size_of::<T::Slots>(), "a slot of another tree");
    slot
}

/// Owns the components of tree `T`.
///
/// The pulse lies beside the slots, so that one pointer is all that a visit needs.
pub(crate) struct Store<T: Layout> {
    pulse: Pulse,
    slots: T::Slots,
}

// SAFETY: nothing is `Shared`, so this never applies. It stands in place of the automatic impl, whose absence the
// compiler explains cell by cell.
unsafe impl<T: Layout> Sync for Store<T> where (): Shared<T> {}

/// A tree that several threads could use. There is none.
#[diagnostic::on_unimplemented(
    message = "activation tree `{T}` cannot be shared: one owner ticks it",
    label = "`{T}` is not `Sync`",
    note = "for a `static`, write `static ROBOT: ConstStaticCell<{T}> = ConstStaticCell::new({T}::new());` with the \
            crate `static_cell`, and take it once with `ROBOT.take()`"
)]
pub(crate) trait Shared<T> {}

impl<T: Layout> Store<T> {
    /// Takes the slots in.
    pub(crate) const fn new(slots: T::Slots) -> Self {
        Self { pulse: Pulse::new(), slots }
    }

    /// What the components have in common; it is never lent.
    #[inline]
    pub(crate) const fn pulse(&self) -> &Pulse {
        &self.pulse
    }

    /// The slots; without a key nobody gets at what is in them.
    pub(crate) const fn slots(&self) -> &T::Slots {
        &self.slots
    }

    /// Reads a component.
    pub(crate) fn get<C: 'static>(&self) -> &C
    where
        T: Has<C>,
    {
        let value = place::<T, C>(&self.slots).value.get();
        // SAFETY: the slot is inside this store. Only `get_mut`, `rate_mut` and `lend` make exclusive references to what
        // is in it; the first two borrow the store exclusively and so does the key that the last needs, so none can
        // exist while `self` is borrowed.
        unsafe { &*value }
    }

    /// Writes a component.
    pub(crate) fn get_mut<C: 'static>(&mut self) -> &mut C
    where
        T: Has<C>,
    {
        let value = place::<T, C>(&self.slots).value.get();
        // SAFETY: the slot is inside this store, which is borrowed exclusively for as long as the reference lives.
        unsafe { &mut *value }
    }

    /// Reads a component's rate.
    pub(crate) fn rate<C: 'static>(&self) -> &Rate<C>
    where
        T: Has<C>,
    {
        let rate = place::<T, C>(&self.slots).rate.get();
        // SAFETY: as in `get`.
        unsafe { &*rate }
    }

    /// Writes a component's rate.
    pub(crate) fn rate_mut<C: 'static>(&mut self) -> &mut Rate<C>
    where
        T: Has<C>,
    {
        let rate = place::<T, C>(&self.slots).rate.get();
        // SAFETY: as in `get_mut`.
        unsafe { &mut *rate }
    }

    /// Opens the store for one cycle.
    pub(crate) const fn open(&mut self) -> Key<'_, T> {
        Key { store: self, exclusive: PhantomData }
    }
}

/// The right to lend the components of one store, made from an exclusive borrow of it.
pub(crate) struct Key<'t, T: Layout> {
    store: &'t Store<T>,
    exclusive: PhantomData<&'t mut T::Slots>,
}

impl<'t, T: Layout> Key<'t, T> {
    /// What the components have in common.
    #[inline]
    pub(crate) const fn pulse(&self) -> &'t Pulse {
        self.store.pulse()
    }

    /// What is remembered of the component of that index, if there is one.
    pub(crate) fn clock_at(&self, index: usize) -> Option<&'t Clock> {
        T::clock(&self.store.slots, index)
    }

    /// What is remembered of `C`.
    #[inline]
    pub(crate) fn clock<C: 'static>(&self) -> &'t Clock
    where
        T: Has<C>,
    {
        T::slot(&self.store.slots).clock()
    }

    /// Lends the components that `L` names, until the key is used again.
    #[inline]
    pub(crate) fn lend<L: Loan<T>>(&mut self) -> L::Lent<'_> {
        const { assert!(distinct(L::CLAIMS), "{}", TWO_LINKS) };
        // SAFETY: a key is the only access to its store, and it is borrowed exclusively for as long as what is lent; its
        // claims are distinct by the line above.
        unsafe { L::lend(&self.store.slots) }
    }
}

/// A list of components to lend together: `()`, or [`Read`], [`Write`] or [`Pace`] of one and the rest.
pub trait Loan<T: Layout>: sealed::Sealed {
    /// What is lent.
    type Lent<'a>;
    /// The places that are lent.
    const CLAIMS: Option<&'static Claim>;

    /// Lends.
    ///
    /// # Safety
    ///
    /// As long as what is lent exists nothing else may refer to the components and rates of `slots`, and no place may
    /// be in the claims twice.
    unsafe fn lend(slots: &T::Slots) -> Self::Lent<'_>;
}

/// Lends `&C`.
pub struct Read<C>(PhantomData<C>);
/// Lends `&mut C`.
pub struct Write<C>(PhantomData<C>);
/// Lends `&mut Rate<C>`.
pub struct Pace<C>(PhantomData<C>);

/// One place that a loan claims.
pub struct Claim {
    index: usize,
    rate: bool,
    rest: Option<&'static Self>,
}

const TWO_LINKS: &str = "two links to one component in one signature";

const fn distinct(mut claims: Option<&Claim>) -> bool {
    while let Some(claim) = claims {
        let mut others = claim.rest;
        while let Some(other) = others {
            if claim.index == other.index && claim.rate == other.rate {
                return false;
            }
            others = other.rest;
        }
        claims = claim.rest;
    }
    true
}

impl<T: Layout> Loan<T> for () {
    type Lent<'a> = ();
    const CLAIMS: Option<&'static Claim> = None;

    #[inline]
    unsafe fn lend(_: &T::Slots) {}
}

impl<T: Has<C>, C: 'static, R: Loan<T>> Loan<T> for (Read<C>, R) {
    type Lent<'a> = (&'a C, R::Lent<'a>);
    const CLAIMS: Option<&'static Claim> = Some(&Claim { index: T::INDEX, rate: false, rest: R::CLAIMS });

    #[inline]
    unsafe fn lend(slots: &T::Slots) -> Self::Lent<'_> {
        let value = place::<T, C>(slots).value.get();
        // SAFETY: the slot is inside `slots`, to whose components nothing else refers, and no other part of this loan
        // names it: the caller's promise.
        unsafe { (&*value, R::lend(slots)) }
    }
}

impl<T: Has<C>, C: 'static, R: Loan<T>> Loan<T> for (Write<C>, R) {
    type Lent<'a> = (&'a mut C, R::Lent<'a>);
    const CLAIMS: Option<&'static Claim> = Some(&Claim { index: T::INDEX, rate: false, rest: R::CLAIMS });

    #[inline]
    unsafe fn lend(slots: &T::Slots) -> Self::Lent<'_> {
        let value = place::<T, C>(slots).value.get();
        // SAFETY: as for `Read`.
        unsafe { (&mut *value, R::lend(slots)) }
    }
}

impl<T: Has<C>, C: 'static, R: Loan<T>> Loan<T> for (Pace<C>, R) {
    type Lent<'a> = (&'a mut Rate<C>, R::Lent<'a>);
    const CLAIMS: Option<&'static Claim> = Some(&Claim { index: T::INDEX, rate: true, rest: R::CLAIMS });

    #[inline]
    unsafe fn lend(slots: &T::Slots) -> Self::Lent<'_> {
        let rate = place::<T, C>(slots).rate.get();
        // SAFETY: as for `Read`; a component and its rate are two cells.
        unsafe { (&mut *rate, R::lend(slots)) }
    }
}

mod sealed {
    /// Only this module knows how to lend.
    pub trait Sealed {}

    impl Sealed for () {}
    impl<C, R> Sealed for (super::Read<C>, R) {}
    impl<C, R> Sealed for (super::Write<C>, R) {}
    impl<C, R> Sealed for (super::Pace<C>, R) {}
}
