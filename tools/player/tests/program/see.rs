//! Detections of recorded images, one line for each, and their score.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::process::{self, Folder, run};
use crate::test_image::{self, ORANGE, RED};

fn keys(value: &Value) -> Vec<&String> {
    value.as_object().expect("an object").keys().collect()
}

#[test]
fn json_lines_have_the_documented_fields() {
    let folder = Folder::new("see/lines");
    test_image::png(&folder.path().join("2.png"), &test_image::rgb(&[(160, 150, 14, ORANGE)]));
    test_image::png(&folder.path().join("1.png"), &test_image::rgb(&[]));
    let ran = run(&["see", folder.text(), "--json"]);
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""));
    let lines = ran.lines();
    assert_eq!((&lines[0]["file"], &lines[1]["file"], lines.len()), (&"1.png".into(), &"2.png".into(), 2));
    let fields = ["ball", "circle", "crossings", "field_end", "file", "goals", "lines", "pose", "robots", "wall_ms"];
    assert_eq!(keys(&lines[1]), fields);
    assert_eq!(keys(&lines[1]["ball"]), ["confidence", "ground", "radius", "x", "y"]);
    assert!(lines[0]["ball"].is_null() && lines[1]["ball"]["ground"].is_null());
    assert!(lines.iter().all(|line| line["field_end"][0][1].as_f64().is_some_and(|row| (row - 60.0).abs() < 4.0)));
}

#[test]
fn all_image_formats_give_the_same_detections() {
    let folder = Folder::new("see/formats");
    let (rgb, path) = (test_image::rgb(&[(101, 150, 14, ORANGE)]), |name: &str| folder.path().join(name));
    test_image::png(&path("a.png"), &rgb);
    test_image::jpeg(&path("b.JPG"), &rgb);
    test_image::yuyv(&path("c_320x240.yuyv"), &rgb, false);
    test_image::yuyv(&path("d_640x240.yuyv"), &rgb, true);
    let ran = run(&["see", folder.text(), "--json", "--pictures", path("seen").to_str().expect("UTF-8")]);
    let lines = ran.lines();
    assert_eq!((lines.len(), ran.stderr.as_str()), (4, ""));
    for line in lines {
        let near =
            |key: &str, expected: f64| line["ball"][key].as_f64().is_some_and(|found| (found - expected).abs() < 1.0);
        assert!(near("x", 101.0) && near("y", 150.0) && near("radius", 14.0), "{line}");
    }
    assert!(path("seen/d_640x240.png").is_file());
}

#[test]
fn broken_images_are_skipped_with_their_names() {
    let folder = Folder::new("see/broken");
    let (rgb, path) = (test_image::rgb(&[]), |name: &str| folder.path().join(name));
    test_image::jpeg(&path("a.jpg"), &rgb);
    let whole = fs::read(path("a.jpg")).expect("a file");
    fs::write(path("b.jpg"), &whole[..whole.len() / 2]).expect("a file");
    fs::write(path("c_640x240.yuyv"), [1, 2, 3]).expect("a file");
    fs::write(path("d.yuyv"), [1, 2, 3]).expect("a file");
    fs::write(path("e.png"), [1, 2, 3]).expect("a file");
    let ran = run(&["see", folder.text(), "--json"]);
    assert_eq!((ran.code, ran.lines().len()), (Some(0), 1));
    for word in ["b.jpg", "c_640x240.yuyv", "307200 bytes, found 3", "NAME_WxH", "e.png"] {
        assert!(ran.stderr.contains(word), "{word} in {}", ran.stderr);
    }
}

#[test]
fn the_score_counts_correct_and_wrong_detections() {
    let folder = Folder::new("see/score");
    for (name, discs) in [
        ("1.png", vec![(100, 150, 14, ORANGE)]),
        ("2.png", vec![(200, 150, 14, ORANGE), (60, 200, 12, RED)]),
        ("3.png", vec![(100, 150, 14, ORANGE)]),
        ("4.png", vec![(100, 150, 14, RED)]),
    ] {
        test_image::png(&folder.path().join(name), &test_image::rgb(&discs));
    }
    let labels = folder.path().join("labels.csv");
    let rows =
        "1.png,100,150,14,full,\n2.png,100,150,14,full,1:2:30:40:blue:complete\n3.png,none,,,,\n4.png,none,,,,\n";
    fs::write(&labels, format!("file,ball_x,ball_y,ball_radius,ball_flag,goal\n{rows}")).expect("a file");
    let score = ["see", folder.text(), "--json", "--score", labels.to_str().expect("UTF-8")];
    let ran = run(&score);
    let score = &ran.lines()[4]["score"];
    // Image 1: correct. Image 2: wrong position. Image 3: not labelled. Image 4: a red ball, which is not the ball of the game.
    let share = |of: i32, good: i32| serde_json::json!({"of": of, "good": good});
    assert_eq!((&score["recall"], &score["precision"]), (&share(2, 1), &share(3, 1)), "{score}");
    assert_eq!((&score["missed"], &score["goals"]["complete"]), (&serde_json::json!(["2.png"]), &share(1, 0)));
    assert!(score["centre_px"]["max"].as_f64().is_some_and(|error| (error - 100.0).abs() < 1.0));
}

#[test]
fn profiles_are_loaded_by_name_or_from_files() {
    let folder = Folder::new("see/profile");
    let path = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    test_image::png(&folder.path().join("1.png"), &test_image::rgb(&[(100, 150, 14, ORANGE)]));
    fs::write(path("all.bin"), vec![0; 64 * 64 * 64]).expect("a file");
    fs::write(path("short.bin"), vec![0; 99]).expect("a file");
    let profile = "[orange]\nhue = [110, 150]\nchroma = 30\n[yellow]\nluma = [0, 0]\n[blue]\nluma = [0, 0]\n\
        [green]\nhue = [150, 270]\n[white]\nluma = [0, 0]\n";
    fs::write(path("hall.toml"), profile).expect("a file");
    fs::write(path("bad.toml"), profile.replace("chroma = 30", "chroma = 300")).expect("a file");
    let sees = |profile: &str| {
        let ran = run(&["see", folder.text(), "--json", "--profile", profile]);
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        ran.lines()[0]["ball"].is_object()
    };
    assert!(sees("built-in") && sees("nao2009") && sees(&path("hall.toml")));
    assert!(!sees("darwin2013"), "the carpet of this profile is greener");
    assert!(!sees(&path("all.bin")), "a table without orange");
    let refused = |profile: &str, words: &[&str]| {
        let ran = process::refused(&["see", folder.text(), "--profile", profile], words);
        assert_eq!(ran.stdout, "");
    };
    refused("nao2010", &["nao2010", "help: name a TOML file", "darwin2013"]);
    refused(&path("bad.toml"), &["bad.toml", "line 3 `chroma = 300`", "`300`", "`chroma = min` (0 to 255)"]);
    refused(&path("short.bin"), &["short.bin", "99 bytes", "64×64×64"]);
}

/// Returns the score of a folder of real images.
fn score(images: &Path, folder: &str) -> Value {
    let text = |path: PathBuf| path.to_str().expect("UTF-8").to_owned();
    let (dir, labels) = (text(images.join(folder)), text(images.join("labels.csv")));
    let ran = run(&["see", &dir, "--json", "--profile", folder, "--score", &labels]);
    println!("{folder}:\n{}", ran.stderr);
    ran.lines().pop().expect("a score")["score"].take()
}

fn part(share: &Value) -> f64 {
    share["good"].as_f64().expect("a count") / share["of"].as_f64().expect("a count")
}

fn figure(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("`{value}` is not a number"))
}

bica_test_data::images_test! {
    fn detections_in_nao_images_reach_their_scores() {
        let score = score(bica_test_data::images(), "nao2009");
        assert!(score["recall"]["of"] == 66 && part(&score["recall"]) >= 0.98, "{score}");
        assert!(part(&score["precision"]) >= 0.99, "{score}");
        let centre = &score["centre_px"];
        assert!(figure(&centre["p50"]) <= 0.5 && figure(&centre["p95"]) <= 1.3 && part(&score["near"]) >= 0.95, "{score}");
        let goals = &score["goals"];
        assert!(figure(&goals["complete"]["of"]) >= 15.0 && figure(&goals["partial"]["of"]) >= 15.0, "{goals}");
        assert!(part(&goals["complete"]) >= 1.0 && part(&goals["partial"]) >= 1.0, "{goals}");
        assert_eq!((part(&goals["without"]), &goals["wrong"]), (1.0, &serde_json::json!([])));
        assert!(figure(&score["same_distance"]["of"]) >= 50.0 && part(&score["same_distance"]) >= 0.95, "{score}");
        assert!(figure(&score["distance"]["p50"]) <= 0.05 && figure(&score["distance"]["p95"]) <= 0.12, "{score}");
        assert!(figure(&score["horizon_px"]["max"]) <= 2.0, "{score}");
    }

    fn detections_in_darwin_images_reach_their_scores() {
        let score = score(bica_test_data::images(), "darwin2013");
        assert!(score["labelled"] == 8 && score["recall"]["of"] == 7, "{score}");
        assert!(part(&score["recall"]) >= 0.99 && part(&score["precision"]) >= 0.99, "{score}");
        let goals = &score["goals"];
        assert!(part(&goals["complete"]) >= 0.9 && part(&goals["partial"]) >= 0.8, "{goals}");
        assert_eq!(&goals["wrong"], &serde_json::json!([]));
    }
}
