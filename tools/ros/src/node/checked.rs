//! Names of a robot, checked before its node exists.

use bica_recording::NameTable;
use bica_recording::ros::{Names, Topics};
use bica_wire::model::{Description, Invalid};

use super::Options;
use super::calls;
use super::drive::Drive;

/// Returns the names of a robot if ROS accepts them and all of them are unique.
pub(super) fn checked(description: &Description, options: &Options) -> Result<Names, Invalid> {
    let names = Names::new(description, &options.namespace)?;
    let (mut topics, mut services) = (NameTable::new("ROS topic"), NameTable::new("ROS service"));
    Topics::new(description, names.clone(), true).check(&mut topics)?;
    if Drive::find(description).is_some() {
        topics.add(names.public("cmd_vel"), "the topic that drives the robot")?;
    }
    for (name, source, target) in calls::services(description, true, &names) {
        if target.takes_numbers() || matches!(target, calls::Target::Stop) {
            topics.add(&name, &source)?;
        }
        services.add(name, source)?;
    }
    Ok(names)
}

#[cfg(test)]
#[expect(clippy::unused_self, reason = "getters and transitions have a receiver")]
mod tests {
    use bica::prelude::*;

    use super::*;

    struct Lease;

    /// Has a modulation whose name is that of a service of the node.
    #[component]
    impl Lease {
        const fn new() -> Self {
            Self
        }

        /// Does nothing.
        #[modulation]
        fn acquire(&mut self) {}
    }

    activation_tree! { struct Leased { root: Lease, cycle_hz: 50, components: [Lease] } }

    struct Lamp;

    /// Has an output whose name is that of its state.
    #[component]
    impl Lamp {
        const fn new() -> Self {
            Self
        }

        /// A number.
        #[output]
        fn state(&self) -> u32 {
            0
        }

        #[state(initial)]
        fn dark(&mut self) {}

        #[state]
        fn bright(&mut self) {}

        #[transition(dark -> bright)]
        fn on(&self) -> bool {
            true
        }

        #[transition(bright -> dark)]
        fn off(&self) -> bool {
            true
        }
    }

    activation_tree! { struct Lit { root: Lamp, cycle_hz: 50, components: [Lamp] } }

    struct Ruler;

    /// Has two outputs that ROS cannot distinguish.
    #[component]
    impl Ruler {
        const fn new() -> Self {
            Self
        }

        /// A number.
        #[output]
        fn größe(&self) -> u32 {
            0
        }

        /// A number.
        #[output]
        fn grüße(&self) -> u32 {
            0
        }
    }

    activation_tree! { struct Ruled { root: Ruler, cycle_hz: 50, components: [Ruler] } }

    #[test]
    fn two_things_with_one_name_are_refused_by_both() {
        let collisions = [
            (&Leased::GRAPH, ["the modulation `Lease.acquire`", "`lease acquire`", "`/leased/lease/acquire`"]),
            (&Lit::GRAPH, ["the output `Lamp.state`", "the state of `Lamp`", "`/lit/lamp/state`"]),
            (&Ruled::GRAPH, ["`Ruler.größe`", "`Ruler.grüße`", "`/ruled/ruler/gr_e`"]),
        ];
        for (graph, parts) in collisions {
            let refused = checked(&Description::of(graph), &Options::default());
            let Err(Invalid { what, .. }) = refused else { panic!("{parts:?} are accepted") };
            assert!(parts.iter().all(|part| what.contains(part)), "{what}");
        }
    }

    #[test]
    fn a_namespace_that_ros_refuses_is_refused_first() {
        let options = Options { namespace: "7up".to_owned(), ..Options::default() };
        assert!(checked(&Description::of(&Lit::GRAPH), &options).is_err_and(|invalid| invalid.what.contains("7up")));
    }
}
