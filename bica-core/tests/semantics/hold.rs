//! Holding components active or latent.

use super::activity::{Child, Lamp, Parent, Switch};
use super::*;

#[test]
fn held_components_are_visited_after_the_root() {
    let mut tree = Lamp::new();
    tree.hold::<Child>(Hold::Active);
    tree.hold::<Parent>(Hold::Active);
    let expected = ["start Switch", "run Switch", "start Parent", "run Parent", "start Child", "run Child"];
    assert_eq!(cycle(&mut tree, 0), expected);
    assert_eq!(tree.held(Lamp::id::<Child>()), Hold::Active);
    tree.hold::<Parent>(Hold::Tree);
    assert_eq!(cycle(&mut tree, 10), ["run Switch", "skip Child", "stop Parent"]);
    tree.hold::<Child>(Hold::Tree);
    assert_eq!(cycle(&mut tree, 20), ["run Switch", "stop Child"]);
}

#[test]
fn a_component_held_latent_is_not_visited() {
    let mut tree = Lamp::new();
    tree.get_mut::<Switch>().on = true;
    tree.tick(at(0));
    assert!(tree.is_active::<Child>());
    tree.hold::<Parent>(Hold::Latent);
    assert_eq!(cycle(&mut tree, 10), ["run Switch", "stop Parent", "stop Child"]);
    assert_eq!(tree.get::<Parent>().ran, 1);
    tree.hold::<Parent>(Hold::Tree);
    let expected = ["run Switch", "start Parent", "run Parent", "start Child", "run Child"];
    assert_eq!(cycle(&mut tree, 20), expected);
}

#[test]
fn a_latent_root_stops_the_tree() {
    let mut tree = Lamp::new();
    tree.tick(at(0));
    tree.hold::<Switch>(Hold::Latent);
    assert_eq!(cycle(&mut tree, 10), ["stop Switch"]);
    assert!(cycle(&mut tree, 20).is_empty());
    assert_eq!(tree.active().count(), 0);
}

#[test]
fn the_last_hold_applies() {
    let mut tree = Lamp::new();
    tree.hold::<Child>(Hold::Latent);
    tree.hold::<Child>(Hold::Active);
    tree.tick(at(0));
    assert!(tree.is_active::<Child>());
}
