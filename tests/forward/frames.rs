//! Frames of the outputs.

use bica::Tree;
use bica::output::Output;
use bica_player::Forward;

fn outputs() -> impl Iterator<Item = &'static Output> {
    Forward::GRAPH.nodes.iter().flat_map(|node| node.outputs)
}

/// Returns the parent frame of a frame.
fn parent(frame: &str) -> Option<&'static str> {
    let mut places = outputs().filter_map(|output| output.placement).filter(|place| place.child == Some(frame));
    places.next().map(|place| place.frame)
}

#[test]
fn every_frame_has_its_place_in_the_field() {
    for (output, place) in outputs().filter_map(|output| output.placement.map(|place| (output, place))) {
        let frames: Vec<_> = std::iter::successors(Some(place.frame), |frame| parent(frame)).take(9).collect();
        assert_eq!(frames.last(), Some(&"field"), "`{}` is in {frames:?}", output.name);
    }
    let drawn = outputs().filter(|output| output.placement.is_some()).count();
    assert!(drawn > 12, "only {drawn} outputs have a frame");
}
