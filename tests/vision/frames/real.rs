//! Detection in recorded frames: a table of scores, with bounds.

use std::fs;

use bica_test_data::{images, images_test};
use bica_vision::ball::{Ball, BallFinder, RADIUS_2009};
use bica_vision::colour::{Classify, Colour, Filters};
use bica_vision::field_boundary::FieldBoundary;
use bica_vision::frame::{Frame, Pair};
use bica_vision::goal::{Goal, GoalFinder};
use bica_vision::profile::{DARWIN_2013, NAO_2009};
use bica_vision::table::{CompactTable, FullTable};

use super::recorded::{self, BallLabel, GoalLabel, Labelled};

/// Counts over a folder.
#[derive(Debug, Default)]
struct Score {
    full: usize,
    full_found: usize,
    right: usize,
    wrong: Vec<String>,
    complete: usize,
    complete_found: usize,
    partial: usize,
    partial_found: usize,
    false_goals: Vec<String>,
    centre_errors: Vec<f32>,
    radius_errors: Vec<f32>,
}

fn is_hit(ball: &Ball, label: &BallLabel) -> bool {
    label.orange && ball.centre.distance(label.centre) <= (0.5 * label.radius).max(3.0)
}

fn overlap(goal: &Goal, label: &GoalLabel) -> f32 {
    let size = goal.max.min(label.max) - goal.min.max(label.min);
    let common = size.x.max(0.0) * size.y.max(0.0);
    let area = |size: glam::Vec2| size.x * size.y;
    common / (area(goal.max - goal.min) + area(label.max - label.min) - common)
}

impl Score {
    fn count_ball(&mut self, image: &Labelled, ball: Option<Ball>) {
        let hit = ball.and_then(|ball| Some((ball, image.balls.iter().find(|label| is_hit(&ball, label))?)));
        let has_full = image.balls.iter().any(|label| label.orange && label.flag == "full");
        self.full += usize::from(has_full);
        self.full_found += usize::from(has_full && hit.is_some());
        if let Some((ball, label)) = hit {
            self.right += 1;
            self.centre_errors.push(ball.centre.distance(label.centre));
            self.radius_errors.push((ball.radius - label.radius).abs());
        } else if let Some(ball) = ball {
            self.wrong.push(format!("{} {ball:?}", image.file));
        }
    }

    fn count_goal(&mut self, image: &Labelled, goals: [Option<Goal>; 2]) {
        let of_colour = |colour| goals.into_iter().flatten().find(|goal| goal.colour == colour);
        match &image.goal {
            Some(label) if label.complete => {
                self.complete += 1;
                let found = of_colour(label.colour).is_some_and(|goal| overlap(&goal, label) >= 0.6);
                self.complete_found += usize::from(found);
            }
            Some(label) => {
                self.partial += 1;
                self.partial_found += usize::from(of_colour(label.colour).is_some());
            }
            None if goals.iter().any(Option::is_some) => self.false_goals.push(format!("{} {goals:?}", image.file)),
            None => {}
        }
    }

    fn print(&mut self, folder: &str) {
        let worst = |errors: &mut Vec<f32>| {
            errors.sort_by(f32::total_cmp);
            (errors.get(errors.len() / 2).copied(), errors.get(errors.len() * 95 / 100).copied())
        };
        println!("{folder}: full balls found {}/{}", self.full_found, self.full);
        println!("  balls correct {} wrong {:?}", self.right, self.wrong);
        println!("  centre error p50, p95 px {:?}", worst(&mut self.centre_errors));
        println!("  radius error p50, p95 px {:?}", worst(&mut self.radius_errors));
        println!("  goals: complete {}/{}", self.complete_found, self.complete);
        println!("  goals: partial {}/{} false {:?}", self.partial_found, self.partial, self.false_goals);
    }

    fn recall(&self) -> f32 {
        self.full_found as f32 / self.full as f32
    }

    fn precision(&self) -> f32 {
        self.right as f32 / (self.right + self.wrong.len()) as f32
    }
}

fn score(images: &[Labelled], filters: &Filters) -> Score {
    let table = CompactTable::compile(filters);
    let (mut balls, mut goals) = (BallFinder::<512>::new(RADIUS_2009), GoalFinder::<1024>::new());
    let mut score = Score::default();
    for image in images {
        let frame = image.frame();
        let end = FieldBoundary::find(&frame, &table);
        score.count_ball(image, balls.find(&frame, &table, &end, None));
        let seen = goals.find(&frame, &table, &end, None);
        score.count_goal(image, [seen.yellow, seen.blue]);
    }
    score
}

images_test! {
    fn detectors_find_balls_and_goals_of_nao_2009() {
        let mut score = score(&recorded::labelled("nao2009"), &NAO_2009);
        score.print("nao2009");
        assert!(score.full >= 60 && score.complete >= 15 && score.partial >= 15, "labels are missing");
        assert!(score.recall() >= 0.98 && score.precision() >= 0.99);
        assert!(score.centre_errors[score.centre_errors.len() / 2] <= 0.5, "median error of the centre");
        assert!(score.centre_errors[score.centre_errors.len() * 95 / 100] <= 1.3, "error of the centre, 95 %");
        assert_eq!((score.complete_found, score.partial_found), (score.complete, score.partial));
        assert_eq!(score.false_goals, Vec::<String>::new());
    }

    fn detectors_find_balls_and_goals_of_darwin_2013() {
        let mut score = score(&recorded::labelled("darwin2013"), &DARWIN_2013);
        score.print("darwin2013");
        assert!(score.full >= 7, "labels are missing");
        assert!(score.recall() >= 0.99 && score.precision() >= 0.99);
        assert!(score.complete_found >= 1 && score.partial_found >= 3);
        assert_eq!(score.false_goals, Vec::<String>::new());
    }

    fn ball_distances_from_pose_and_from_size_agree() {
        let (table, mut finder) = (CompactTable::compile(&NAO_2009), BallFinder::<512>::new(RADIUS_2009));
        let labelled = recorded::labelled("nao2009");
        let (mut ratios, mut full) = (Vec::new(), 0);
        for (file, camera, horizon, trusted) in recorded::poses() {
            // Column 159.5 of the file is the image centre, 160 in the intrinsics.
            let row = camera.horizon(160.0).expect("the robot stands");
            assert!((row - horizon).abs() < 0.05 + 2e-4 * horizon.abs(), "{file}: horizon at {row}, not {horizon}");
            let image = labelled.iter().find(|image| image.file == file).filter(|_| trusted);
            let Some(image) = image.filter(|image| image.balls.iter().any(|ball| ball.flag == "full")) else { continue };
            full += 1;
            let frame = image.frame();
            let ball = finder.find(&frame, &table, &FieldBoundary::find(&frame, &table), Some(&camera));
            let Some(ball) = ball else { continue };
            let by_pose = camera.ground(ball.centre, RADIUS_2009).expect("below the horizon").extend(RADIUS_2009);
            let by_pose = by_pose.distance(camera.pose().translation.into());
            let by_size = camera.distance_by_radius(ball.centre, ball.radius, RADIUS_2009).expect("a radius");
            ratios.push((by_pose / by_size - 1.0).abs());
        }
        ratios.sort_by(f32::total_cmp);
        let (median, most) = (ratios[ratios.len() / 2], ratios[ratios.len() * 95 / 100]);
        println!("distance by pose against size: {} of {full} balls, median {median:.3}, 95 % {most:.3}", ratios.len());
        assert!(ratios.len() == full && median <= 0.05 && most <= 0.12);
    }

    fn colour_table_of_another_team_agrees_on_the_ball() {
        let bytes = fs::read(images().join("luts/bhuman2009_y64_cb64_cr64.bin")).expect("the table");
        let (other, own) = (FullTable::new(&bytes).expect("its size"), CompactTable::compile(&NAO_2009));
        let (mut both, mut only_other, mut found) = (0_u32, 0_u32, 0);
        let labelled = recorded::labelled("nao2009");
        let full: Vec<_> = labelled.iter().filter(|image| image.balls.iter().any(|ball| ball.flag == "full")).collect();
        for image in &full {
            let frame = image.frame();
            for pixel in (0..frame.height()).flat_map(|row| frame.row(row)).map(|pair| Pair(*pair).mean()) {
                if other.classify(pixel) == Colour::Orange {
                    let agreed = u32::from(own.classify(pixel) == Colour::Orange);
                    (both, only_other) = (both + agreed, only_other + 1 - agreed);
                }
            }
            let end = FieldBoundary::find(&frame, &other);
            let ball = BallFinder::<1024>::new(RADIUS_2009).find(&frame, &other, &end, None);
            found += usize::from(ball.is_some_and(|ball| image.balls.iter().any(|label| is_hit(&ball, label))));
        }
        println!(
            "orange in both tables: {both}, only in the other table: {only_other}; balls by the other table {found}/{}",
            full.len()
        );
        assert!(both >= 10 * only_other && found * 100 >= full.len() * 98);
    }

    fn raw_yuyv_frames_of_the_camera_are_read_directly() {
        let table = CompactTable::compile(&NAO_2009);
        for (file, has_ball) in [("008", true), ("030", false), ("044", true), ("117", true)] {
            // The robot stored every second row of 640 × 480, so circles are twice as wide: skip every second pair.
            let bytes = fs::read(images().join(format!("yuyv/{file}_640x240.yuyv"))).expect("a frame");
            let half: Vec<u8> =
                bytes.as_chunks::<4>().0.iter().flat_map(|[y0, cb, y1, cr]| [u8::midpoint(*y0, *y1), *cb, *cr]).collect();
            let half: Vec<u8> =
                half.as_chunks::<6>().0.iter().flat_map(|[a, cb, cr, b, _, _]| [*a, *cb, *b, *cr]).collect();
            let frame = Frame::new(320, 240, &half).expect("a frame");
            let end = FieldBoundary::find(&frame, &table);
            assert_eq!(BallFinder::<512>::new(RADIUS_2009).find(&frame, &table, &end, None).is_some(), has_ball, "{file}");
        }
    }
}
