//! Memory of several objects of one kind.

use bica_motion::pose::Pose2;
use bica_vision::memory::multi_target::MultiTargetMemory;
use bica_vision::uncertainty::round;
use glam::Vec2;

fn places<const N: usize>(things: &MultiTargetMemory<N>) -> Vec<Vec2> {
    let mut places: Vec<Vec2> = things.places().map(|place| place.position).collect();
    places.sort_by(|a, b| a.x.total_cmp(&b.x));
    places
}

#[test]
fn sighting_updates_the_nearest_object_or_adds_one() {
    let mut robots = MultiTargetMemory::<3>::new(10.0);
    let truth = [Vec2::new(0.5, 0.3), Vec2::new(1.0, -0.4), Vec2::new(1.8, 0.5)];
    for turn in 0..20 {
        let off = if turn % 2 == 0 { 0.03 } else { -0.03 };
        for at in truth {
            robots.see(at + off, &round(0.05), 0.8);
        }
        robots.advance(Pose2::new(0.0, 0.0, 0.0), 0.03);
    }
    let found = places(&robots);
    assert_eq!(found.len(), 3, "{found:?}");
    assert!(found.iter().zip(truth).all(|(found, at)| found.distance(at) < 0.03), "{found:?}");
    let step = Pose2::new(0.2, 0.1, 0.3);
    robots.advance(step, 0.1);
    let mut moved = truth.map(|at| step.locate(at));
    moved.sort_by(|a, b| a.x.total_cmp(&b.x));
    assert!(places(&robots).iter().zip(moved).all(|(found, at)| found.distance(at) < 0.03));
}

#[test]
fn full_memory_replaces_the_least_confident() {
    let mut robots = MultiTargetMemory::<2>::new(1.0);
    robots.see(Vec2::new(1.0, 0.0), &round(0.05), 0.8);
    robots.advance(Pose2::ORIGIN, 1.0);
    robots.see(Vec2::new(2.0, 0.0), &round(0.05), 0.8);
    robots.see(Vec2::new(3.0, 0.0), &round(0.05), 0.8);
    assert_eq!(places(&robots), [Vec2::new(2.0, 0.0), Vec2::new(3.0, 0.0)]);
    robots.see(Vec2::new(0.5, 0.0), &round(0.05), 0.1);
    assert_eq!(places(&robots).len(), 2);
    assert_eq!(places(&robots)[0], Vec2::new(2.0, 0.0));
}

#[test]
fn only_the_missing_object_in_view_is_forgotten() {
    let mut robots = MultiTargetMemory::<4>::new(100.0);
    let (there, gone) = (Vec2::new(1.0, 0.5), Vec2::new(1.0, -0.5));
    robots.see(gone, &round(0.05), 0.8);
    for _ in 0..20 {
        robots.advance(Pose2::ORIGIN, 0.03);
        robots.see(there, &round(0.05), 0.8);
        robots.miss(|_| true);
    }
    let found = places(&robots);
    assert!(found.len() == 1 && found[0].distance(there) < 1e-3, "{found:?}");
    (0..20).for_each(|_| robots.miss(|_| false));
    assert_eq!(places(&robots), found);
}
