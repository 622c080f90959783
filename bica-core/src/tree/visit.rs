//! The visit of one component, written into each tree.
//!
//! These functions call each other along the activation graph, through [`MemberOf::pass`](super::layout::MemberOf::pass).
//! They are a macro and not generic functions because the compiler limits how deep a generic function may instantiate
//! itself (`recursion_limit`, 128): a long chain of components would exceed that. As functions of the generated
//! implementations each component has its own.

/// The functions of `Has<$component>` that visit the component.
#[doc(hidden)]
#[macro_export]
macro_rules! __visit_functions {
    ($component:ty) => {
        #[inline]
        fn visit<__P: $crate::__private::Probe>(cycle: &mut $crate::__private::Cycle<'_, Self, __P>) {
            if const { $crate::__private::is_deferred::<Self, $component>() } {
                cycle.defer::<$component>();
            } else if !const { $crate::__private::is_shared::<Self, $component>() } {
                <Self as $crate::__private::Has<$component>>::visit_once(cycle);
            } else if !cycle.was_visited::<$component>() {
                <Self as $crate::__private::Has<$component>>::visit_shared(cycle);
            }
        }

        #[cfg_attr(not(target_os = "none"), inline(never))]
        fn visit_shared<__P: $crate::__private::Probe>(cycle: &mut $crate::__private::Cycle<'_, Self, __P>) {
            <Self as $crate::__private::Has<$component>>::visit_once(cycle);
        }

        #[inline]
        fn visit_once<__P: $crate::__private::Probe>(cycle: &mut $crate::__private::Cycle<'_, Self, __P>) {
            if const { $crate::__private::visits_at_rate::<Self, $component>() } {
                let outcome = if cycle.visits_as_before::<$component>() {
                    if cycle.is_due::<$component>() {
                        $crate::__private::VisitOutcome::DUE
                    } else {
                        $crate::__private::VisitOutcome::WAITING
                    }
                } else {
                    <Self as $crate::__private::Has<$component>>::visit_otherwise(cycle)
                };
                if !outcome.is_closed() {
                    let visit = $crate::__private::Visit { due: outcome.is_due(), entering: outcome.is_entering() };
                    if !visit.due {
                        cycle.skip::<$component>();
                    }
                    $crate::__pass!($component, cycle, visit);
                }
                return;
            }
            // Paths merge before component values are live, which avoids spills.
            let outcome = if cycle.visits_as_before::<$component>() {
                $crate::__private::VisitOutcome::DUE
            } else {
                <Self as $crate::__private::Has<$component>>::visit_unusual(cycle)
            };
            if !outcome.is_closed() {
                let visit = $crate::__private::Visit { due: true, entering: outcome.is_entering() };
                $crate::__pass!($component, cycle, visit);
            }
        }

        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn visit_otherwise<__P: $crate::__private::Probe>(
            cycle: &mut $crate::__private::Cycle<'_, Self, __P>,
        ) -> $crate::__private::VisitOutcome {
            let outcome = cycle.visit_any::<$component>();
            if const { $crate::__private::goes::<Self, $component>() } {
                // Closed visits, of what is held latent, ask for no request.
                if outcome.is_closed() {
                    return $crate::__private::VisitOutcome::CLOSED;
                }
                if cycle.is_going::<$component>(outcome) {
                    $crate::__pass!($component, cycle);
                    return $crate::__private::VisitOutcome::CLOSED;
                }
            }
            outcome
        }

        // Nested visits become one function without calls.
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn visit_steady<__P: $crate::__private::Probe, const __PLAN: ::core::primitive::usize>(
            cycle: &mut $crate::__private::Cycle<'_, Self, __P>,
        ) {
            if const { $crate::__private::is_fixed::<Self, $component>(__PLAN) } {
                let is_due = cycle.visit_steady::<$component>();
                $crate::__pass!($component, cycle, is_due, __PLAN);
            } else {
                <Self as $crate::__private::Has<$component>>::visit(cycle);
            }
        }

        #[cold]
        #[inline(never)]
        fn visit_unusual<__P: $crate::__private::Probe>(
            cycle: &mut $crate::__private::Cycle<'_, Self, __P>,
        ) -> $crate::__private::VisitOutcome {
            let outcome = <Self as $crate::__private::Has<$component>>::visit_otherwise(cycle);
            if !cycle.is_given_rate::<$component>() || outcome.is_due() || outcome.is_closed() {
                return outcome;
            }
            cycle.skip::<$component>();
            let visit = $crate::__private::Visit { due: false, entering: false };
            $crate::__pass!($component, cycle, visit);
            $crate::__private::VisitOutcome::CLOSED
        }
    };
}

/// Calls `MemberOf::pass`, `MemberOf::pass_steady` or `MemberOf::go` of the component. The function in between knows of the component
/// only that a tree holds it: if a child is not listed, the compiler reports that once, at the list, and not again for
/// every call.
#[doc(hidden)]
#[macro_export]
macro_rules! __pass {
    ($component:ty, $cycle:ident) => {{
        #[cold]
        #[inline(never)]
        fn go<__T: $crate::__private::Has<$component>, __P: $crate::__private::Probe>(
            cycle: &mut $crate::__private::Cycle<'_, __T, __P>,
        ) {
            <__T::Member as $crate::__private::MemberOf<__T>>::go(cycle);
        }
        go::<Self, __P>($cycle);
    }};
    ($component:ty, $cycle:ident, $visit:ident) => {{
        #[inline(always)]
        fn pass<__T: $crate::__private::Has<$component>, __P: $crate::__private::Probe>(
            cycle: &mut $crate::__private::Cycle<'_, __T, __P>,
            visit: $crate::__private::Visit,
        ) {
            <__T::Member as $crate::__private::MemberOf<__T>>::pass(cycle, visit);
        }
        pass::<Self, __P>($cycle, $visit);
    }};
    ($component:ty, $cycle:ident, $is_due:ident, $plan:ident) => {{
        #[inline(always)]
        fn pass<
            __T: $crate::__private::Has<$component>,
            __P: $crate::__private::Probe,
            const __PLAN: ::core::primitive::usize,
        >(
            cycle: &mut $crate::__private::Cycle<'_, __T, __P>,
            is_due: ::core::primitive::bool,
        ) {
            <__T::Member as $crate::__private::MemberOf<__T>>::pass_steady::<__P, __PLAN>(cycle, is_due);
        }
        pass::<Self, __P, $plan>($cycle, $is_due);
    }};
}
