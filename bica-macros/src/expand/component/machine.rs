//! The visit of a state machine.
//!
//! One round through the loop is one state. A transition ends its round early and the next begins in the new state, so
//! that the state that is not left costs one `match`.
//!
//! What a transition carries is a variable of the visit, which the loop takes over from a steady tick. A trait of the component's own
//! names its type: as a part of `MemberOf`, it could not be private.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Generics, Type};

use super::call;
use super::node;
use super::role;
use super::slots::Slots;
use super::tuning::Tuning;
use super::visits::Visits;
use bica_syntax::component::model::{Edge, Function, Machine, Timer};

/// What the code of each state depends on.
pub(super) struct Parts<'a> {
    pub(super) p: &'a TokenStream,
    pub(super) machine: &'a Machine,
    pub(super) visits: &'a Visits,
    pub(super) tuning: &'a Tuning,
    pub(super) slots: Slots<'a>,
}

impl Parts<'_> {
    /// The functions of `MemberOf` that run the machine.
    pub(super) fn functions(&self) -> TokenStream {
        let p = self.p;
        let steady = self.visits.exist().then(|| self.steady());
        let empty = self.slots.exist().then(|| self.slots.empty());
        let (proceed, by_request) = (self.proceed(empty.clone(), false), self.proceed(empty, true));
        let own = (!self.slots.exist()).then(|| self.proceeding());
        let go = self.go(&by_request);
        let progress = self.progress();
        let asked = self.asked(self.machine.initial);
        let entered = asked.map(|asked| quote!(if visit.entering { #asked }));
        quote! {
            #[inline]
            fn pass<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, __T, __P>, visit: #p::Visit) {
                #entered
                let machine = cycle.#progress::<Self>(visit);
                #proceed;
            }

            #steady

            #go

            #own
        }
    }

    /// The run in which the machine goes to a state by request.
    fn go(&self, proceed: &TokenStream) -> TokenStream {
        let p = self.p;
        let exits = self.machine.states.iter().enumerate().filter(|(_, state)| !state.exits.is_empty());
        let exits = exits.map(|(index, state)| {
            let calls = self.calls(&state.exits);
            quote!(#index => { #calls })
        });
        let asked = (0..self.machine.states.len()).filter_map(|state| {
            let asked = self.asked(state)?;
            Some(quote!(#state => { #asked }))
        });
        quote! {
            fn go<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, __T, __P>) {
                let (from, to) = cycle.begin_going::<Self>();
                match from { #(#exits)* _ => {} }
                let machine = cycle.transition::<Self>(from, to);
                match to { #(#asked)* _ => {} }
                let visit = #p::Visit { due: true, entering: false };
                #proceed;
            }
        }
    }

    /// The trait with the loop of a machine whose transitions carry something, and its implementation.
    pub(super) fn carrying(&self, own: &Type, generics: &Generics) -> Option<TokenStream> {
        let (p, kind, proceed) = (self.p, self.slots.kind(), self.proceeding());
        let (parameters, _, bounds) = generics.split_for_impl();
        self.slots.exist().then(|| {
            quote! {
                trait __Carrying<__T: #p::Layout>: ::core::marker::Sized {
                    type Slots;
                    fn proceed<__P: #p::Probe, const __BY_REQUEST: ::core::primitive::bool>(
                        cycle: &mut #p::Cycle<'_, __T, __P>, visit: #p::Visit, machine: #p::Machine, slots: Self::Slots,
                    );
                }

                #[automatically_derived]
                impl #parameters __Carrying<__T> for #own #bounds {
                    type Slots = #kind;

                    #proceed
                }
            }
        })
    }

    fn steady(&self) -> TokenStream {
        let p = self.p;
        let rounds = self.arms(true);
        let empty = self.slots.empty();
        let slots = self.slots.exist().then(|| quote!(let mut slots: <Self as __Carrying<__T>>::Slots = #empty;));
        let progress = self.progress();
        quote! {
            fn pass_steady<__P: #p::Probe, const __PLAN: ::core::primitive::usize>(cycle: &mut #p::Cycle<'_, __T, __P>, is_due: ::core::primitive::bool) {
                let visit = #p::Visit { due: is_due, entering: false };
                let machine = cycle.#progress::<Self>(visit);
                #slots
                match machine.state {
                    #rounds
                }
            }
        }
    }

    /// The function with the loop.
    fn proceeding(&self) -> TokenStream {
        let p = self.p;
        let rounds = self.arms(false);
        let slots = self.slots.exist().then(|| quote!(mut slots: Self::Slots,));
        quote! {
            #[inline]
            fn proceed<__P: #p::Probe, const __BY_REQUEST: ::core::primitive::bool>(
                cycle: &mut #p::Cycle<'_, __T, __P>,
                visit: #p::Visit,
                mut machine: #p::Machine,
                #slots
            ) {
                loop {
                    match machine.state {
                        #rounds
                    }
                }
            }
        }
    }

    /// The call of the loop, with slots if there are any.
    fn proceed(&self, slots: Option<TokenStream>, by_request: bool) -> TokenStream {
        let p = self.p;
        if let Some(slots) = slots {
            quote!(<Self as __Carrying<__T>>::proceed::<__P, #by_request>(cycle, visit, machine, #slots))
        } else {
            quote!(<Self as #p::MemberOf<__T>>::proceed::<__P, #by_request>(cycle, visit, machine))
        }
    }

    fn arms(&self, steady: bool) -> TokenStream {
        let last = self.machine.states.len() - 1;
        let arms = (0..=last).map(|state| {
            let round = self.round(state, steady);
            if state == last { quote!(_ => #round) } else { quote!(#state => #round) }
        });
        quote!(#(#arms)*)
    }

    fn round(&self, index: usize, steady: bool) -> TokenStream {
        let (p, visits, state) = (self.p, self.visits, &self.machine.states[index]);
        let (before, after) = if steady {
            let plan = quote!(#index);
            (visits.before_steady(index, &plan), visits.after_steady(index, &plan))
        } else {
            (visits.before(index), visits.after(index))
        };
        let entries = state.entries.iter().map(|hook| self.slots.entry(p, index, hook, self.tuning));
        let entering = (!state.entries.is_empty() && !steady).then(|| quote!(if machine.entering { #(#entries)* }));
        let body = call::expand(p, &state.body, self.tuning);
        let exits = self.calls(&state.exits);
        let first = self.calls(state.before.as_slice());
        let edges = self.machine.edges.iter().enumerate().filter(|(_, edge)| edge.from == index);
        let transitions: Vec<_> = edges.map(|(number, edge)| self.leave((number, edge), &exits, steady)).collect();
        let leaving = (!transitions.is_empty()).then(|| quote!(if !machine.moved { #first #(#transitions)* }));
        quote! {{
            #before
            if visit.due {
                cycle.begin_state::<Self>(machine);
                #entering
                #leaving
                #body
                cycle.end_run::<Self>();
            }
            #after
            return;
        }}
    }

    fn calls(&self, functions: &[Function]) -> TokenStream {
        let calls = functions.iter().map(|function| call::expand(self.p, function, self.tuning));
        quote!(#(#calls)*)
    }

    /// Leaves the state if the condition of an edge holds. `number` is the index of the edge in the node's transitions.
    fn leave(&self, (number, edge): (usize, &Edge), exits: &TokenStream, steady: bool) -> TokenStream {
        let (from, to) = (edge.from, edge.to);
        let holds = self.holds(edge);
        let (before, after) = self.counting(number);
        let asked = self.asked(to);
        let entered = quote!(cycle.transition::<Self>(#from, #to); #after #asked);
        let next = if steady {
            let proceed = self.proceed(self.slots.exist().then(|| quote!(slots)), false);
            quote!(let machine = #entered return #proceed;)
        } else {
            quote!(machine = #entered continue;)
        };
        let timer = edge.guard.timer.as_ref().map(|timer| {
            let ms = match timer {
                Timer::Ms(ms) => quote!(#ms),
                Timer::Parameter(timer) => self.tuning.milliseconds(timer),
            };
            quote!(cycle.has_been_in_state::<Self>(#ms) &&)
        });
        let times = edge.guard.times.map(|times| quote!(cycle.taken::<Self>() < #times &&));
        quote! {
            if #timer #times { #holds cycle.condition::<Self>(#number, holds) } {
                #exits
                #before
                #next
            }
        }
    }

    /// Whether a transition can be taken: its result is there, and its function holds.
    fn holds(&self, edge: &Edge) -> TokenStream {
        let p = self.p;
        let result = edge.guard.when.as_ref().map(|when| {
            let (child, end) = (role::child(p, &when.child.0), node::end(when.end));
            quote!(cycle.has_ended::<#child>(#p::End::#end))
        });
        match (result, edge.guard.bare) {
            (result, true) => {
                let result = result.unwrap_or_else(|| quote!(true));
                quote!(let holds = #result;)
            }
            (None, false) => self.slots.holds(edge, &call::expand(p, &edge.condition, self.tuning)),
            (Some(result), false) => {
                let holds = self.slots.holds(edge, &call::expand(p, &edge.condition, self.tuning));
                quote!(let holds = if #result { #holds holds } else { false };)
            }
        }
    }

    /// The function that tells in which state a visit begins.
    fn progress(&self) -> TokenStream {
        if self.counts() { quote!(counted_machine) } else { quote!(machine) }
    }

    /// Whether transitions are counted.
    fn counts(&self) -> bool {
        self.machine.edges.iter().any(|edge| edge.guard.times.is_some())
    }

    /// What counts transitions, before and after the one of this number.
    fn counting(&self, number: usize) -> (Option<TokenStream>, Option<TokenStream>) {
        let counts = self.counts();
        let before = counts.then(|| quote!(let taken = cycle.taken::<Self>();));
        (before, counts.then(|| quote!(cycle.count::<Self>(#number, taken);)))
    }

    /// The children whose results a state asks for begin anew.
    fn asked(&self, state: usize) -> Option<TokenStream> {
        let children: Vec<_> = self.machine.asked_in(state).map(|child| role::child(self.p, child)).collect();
        (!children.is_empty()).then(|| quote!(#(cycle.ask_anew::<#children>();)*))
    }
}
