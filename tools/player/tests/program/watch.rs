//! Detection in recorded images, both intact and broken.

use std::fs;
use std::path::Path;

use crate::process::{self, Folder, run};
use crate::test_image::{self, ORANGE};

const HEADING: &str = "file,r00,r01,r02,r10,r11,r12,r20,r21,r22,tx_mm,ty_mm,tz_mm,trusted\n";
/// Camera pose: 0.5 m high, pitched down by 30°.
const POSE: &str = "0.8660254,0,0.5,0,1,0,-0.5,0,0.8660254,0,0,500";

/// Draws an orange ball at (x, 150) with the size of a ball of 43 mm at that position.
fn draw(path: &Path, x: i32) {
    test_image::png(path, &test_image::rgb(&[(x, 150, 20, ORANGE)]));
}

#[test]
fn a_ball_is_detected_and_projected_to_the_ground() {
    let (folder, seen) = (Folder::new("watch/frames"), Folder::new("watch/seen"));
    for (name, x) in [("2.png", 160), ("1.png", 100)] {
        draw(&folder.path().join(name), x);
    }
    let poses = folder.path().join("poses.csv");
    fs::write(&poses, format!("{HEADING}frames/2.png,{POSE},1\n")).unwrap();
    let ran = run(&["watch", folder.text(), "--poses", poses.to_str().unwrap(), "--pictures", seen.text(), "--json"]);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let printed = ran.json();
    let (first, second) = (&printed["frames"][0], &printed["frames"][1]);
    assert_eq!((&first["file"], &second["file"]), (&"1.png".into(), &"2.png".into()));
    assert_eq!((&first["pose"], &second["pose"]), (&"missing".into(), &"trusted".into()));
    assert!((first["ball"]["x"].as_f64().unwrap() - 100.0).abs() < 2.0, "{first}");
    assert!((second["ball"]["radius"].as_f64().unwrap() - 20.0).abs() < 2.0, "{second}");
    assert!(first["ball"]["ground"].is_null() && printed["summary"]["poses_missing"][0] == "1.png");
    // The ray to the ball's centre points down by 30° + atan(30 / 385.54) and ends 43 mm above the ground.
    let ahead = 0.457 / (30_f64.to_radians() + (30.0_f64 / 385.54).atan()).tan();
    assert!((second["ball"]["ground"][0].as_f64().unwrap() - ahead).abs() < 0.03, "{second}");
    assert_eq!(seen.names(), ["1.png", "2.png"]);
}

#[test]
fn poses_beside_the_folder_are_used_by_default() {
    let outer = Folder::new("beside");
    let frames = outer.path().join("lab");
    fs::create_dir(&frames).unwrap();
    draw(&frames.join("1.png"), 160);
    fs::write(outer.path().join("lab_pose.csv"), format!("{HEADING}lab/1.png,{POSE},1\n")).unwrap();
    let printed = run(&["watch", frames.to_str().unwrap(), "--json"]).json();
    assert_eq!(printed["frames"][0]["pose"], "trusted");
}

#[test]
fn unreadable_files_are_skipped_counted_and_named() {
    let folder = Folder::new("broken");
    draw(&folder.path().join("a.png"), 160);
    let whole = fs::read(folder.path().join("a.png")).unwrap();
    fs::write(folder.path().join("b.png"), &whole[..whole.len() / 2]).unwrap();
    fs::write(folder.path().join("c.PNG"), "no image").unwrap();
    test_image::png_of(&folder.path().join("d.png"), 33, 32, &[90; 33 * 32 * 3]);
    fs::write(folder.path().join("e.txt"), "not looked at").unwrap();
    let ran = run(&["watch", folder.text()]);
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""));
    assert!(ran.stdout.contains("1 read, 3 skipped"), "{}", ran.stdout);
    let printed = run(&["watch", folder.text(), "--json"]).json();
    let skipped: Vec<_> = printed["skipped"].as_array().unwrap().iter().map(|skip| skip["file"].as_str()).collect();
    assert_eq!(skipped, [Some("b.png"), Some("c.PNG"), Some("d.png")]);
    fs::remove_file(folder.path().join("a.png")).unwrap();
    assert_eq!(run(&["watch", folder.text()]).code, Some(1), "no image could be read");
}

#[test]
fn errors_name_the_wrong_folder_or_file() {
    let folder = Folder::new("empty");
    let text = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let refused = |args: &[&str], words: &[&str]| {
        let ran = process::refused(&[&["watch"], args].concat(), words);
        assert_eq!(ran.stdout, "");
    };
    refused(&[&text("nowhere")], &["nowhere", "help: name a folder"]);
    refused(&[folder.text()], &["no image in", folder.text()]);
    draw(&folder.path().join("1.png"), 160);
    refused(&[&text("1.png")], &["1.png", "help: name a folder"]);
    refused(&[folder.text(), "--poses", &text("none.csv")], &["none.csv", "--poses"]);
    fs::write(text("bad.csv"), format!("{HEADING}1.png,{POSE},1\n1.png,one\n")).unwrap();
    refused(&[folder.text(), "--poses", &text("bad.csv")], &["bad.csv", "line 3", "`one` is not a number"]);
    refused(&[folder.text(), "--pictures", &text("bad.csv")], &["bad.csv", "--pictures"]);
}

bica_test_data::images_test! {
    fn balls_are_detected_in_images_of_a_real_robot() {
        let folder = bica_test_data::images().join("nao2009");
        let printed = run(&["watch", folder.to_str().expect("UTF-8"), "--json"]).json();
        assert_eq!((&printed["summary"]["seen"], &printed["summary"]["skipped"]), (&103.into(), &0.into()));
        assert!(printed["summary"]["balls"].as_u64().is_some_and(|balls| balls >= 60), "{}", printed["summary"]);
        let first = &printed["frames"][0]["ball"];
        let near = |key: &str, expected: f64| first[key].as_f64().is_some_and(|found| (found - expected).abs() < 2.0);
        assert!(near("x", 171.2) && near("y", 148.7), "{first}");
    }
}
