//! The robot finds out where on the field it is, by looking around.

#[path = "../support/lookout.rs"]
mod lookout;

use lookout::{Lookout, print};

#[test]
fn it_knows_where_it_is_after_ten_seconds() {
    let outcomes: Vec<_> = (0..15).map(|seed| Lookout::new(seed, 0).look_around(10.0)).collect();
    print(&outcomes);
    assert!(outcomes.iter().filter(|outcome| outcome.is_found()).count() >= 14);
}

#[test]
fn others_on_the_field_and_being_carried_off_do_not_lose_it() {
    let mut outcomes = Vec::new();
    for seed in 100..105 {
        let mut lookout = Lookout::new(seed, 4);
        outcomes.push(lookout.look_around(10.0));
        lookout.kidnap(seed + 1000, 4);
        outcomes.push(lookout.look_around(10.0));
    }
    print(&outcomes);
    assert!(outcomes.iter().filter(|outcome| outcome.is_found()).count() >= 9);
}
