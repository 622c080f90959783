//! Ball detection in recorded frames with the colours of another team, and in raw frames. Tests of the program `player`
//! check the scores of all detectors in these frames.

use std::fs;

use bica_evaluation::frame_io::RecordedFrame;
use bica_test_data::{images, images_test};
use bica_vision::ball::{BallFinder, RADIUS_2009};
use bica_vision::colour::{Classify, Colour};
use bica_vision::field_boundary::FieldBoundary;
use bica_vision::frame::{Frame, Pair};
use bica_vision::profile::NAO_2009;
use bica_vision::table::{CompactTable, FullTable};

use super::recorded::Recorded;

images_test! {
    fn colour_table_of_another_team_agrees_on_the_ball() {
        let bytes = fs::read(images().join("luts/bhuman2009_y64_cb64_cr64.bin")).expect("the table");
        let (other, own) = (FullTable::new(&bytes).expect("its size"), CompactTable::compile(&NAO_2009));
        let (mut both, mut only_other, mut found, mut full) = (0_u32, 0_u32, 0, 0);
        for image in Recorded::all().iter().filter(|image| image.label.balls.iter().any(|ball| ball.full)) {
            let frame = image.frame();
            for pixel in (0..frame.height()).flat_map(|row| frame.row(row)).map(|pair| Pair(*pair).mean()) {
                if other.classify(pixel) == Colour::Orange {
                    let agreed = u32::from(own.classify(pixel) == Colour::Orange);
                    (both, only_other) = (both + agreed, only_other + 1 - agreed);
                }
            }
            let end = FieldBoundary::find(&frame, &other);
            let ball = BallFinder::<1024>::new(RADIUS_2009).find(&frame, &other, &end, None);
            let mut orange = image.label.balls.iter().filter(|ball| ball.orange);
            let is_hit = ball.is_some_and(|ball| {
                orange.any(|label| ball.centre.distance(label.centre) <= (0.5 * label.radius).max(3.0))
            });
            (found, full) = (found + usize::from(is_hit), full + 1);
        }
        println!("orange in both tables: {both}, only in the other table: {only_other}; balls by the other table {found}/{full}");
        assert!(full >= 60 && both >= 10 * only_other && found * 100 >= full * 98);
    }

    fn raw_frames_show_their_balls() {
        let table = CompactTable::compile(&NAO_2009);
        for (file, has_ball) in [("008", true), ("030", false), ("044", true), ("117", true)] {
            let pixels = RecordedFrame::read(&images().join(format!("yuyv/{file}_640x240.yuyv"))).expect("a frame");
            let frame = Frame::from_image(&pixels.image()).expect("a frame");
            let end = FieldBoundary::find(&frame, &table);
            assert_eq!(BallFinder::<512>::new(RADIUS_2009).find(&frame, &table, &end, None).is_some(), has_ball, "{file}");
        }
    }
}
