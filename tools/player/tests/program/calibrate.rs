//! Profiles learned from labelled images.

use std::fs;
use std::path::Path;

use crate::run::{Folder, run};
use crate::scene::{self, ORANGE, RED};
use crate::see::real;

/// Images with a ball each and something red, with the labels; gives the arguments to learn from them.
fn hall(folder: &Folder) -> Vec<String> {
    let mut labels = vec!["file,ball_x,ball_y,ball_radius,ball_flag,goal".to_owned()];
    let mut rectangles = vec!["file,x0,y0,x1,y1,class".to_owned()];
    for index in 0..6 {
        let (x, name) = (60 + 30 * index, format!("{index}.png"));
        scene::png(&folder.path().join(&name), &scene::rgb(&[(x, 150, 14, ORANGE), (x, 200, 16, RED)]));
        labels.push(format!("{name},{x},150,14,full,"));
        rectangles.push(format!("{name},10,70,50,130,field\n{name},10,10,300,50,other"));
    }
    fs::write(folder.path().join("labels.csv"), labels.join("\n")).expect("a file");
    fs::write(folder.path().join("rectangles.csv"), rectangles.join("\n")).expect("a file");
    let text = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let arguments = ["calibrate", folder.text(), "--labels", &text("labels.csv"), "--rectangles"];
    let arguments = arguments.into_iter().map(str::to_owned);
    arguments.chain([text("rectangles.csv"), "--out".to_owned()]).collect()
}

fn learn(arguments: &[String], out: &Path, more: &[&str]) -> crate::run::Ran {
    let arguments = arguments.iter().map(String::as_str);
    run(&arguments.chain([out.to_str().expect("UTF-8")]).chain(more.iter().copied()).collect::<Vec<_>>())
}

#[test]
fn what_was_learned_is_told_and_sees_the_ball() {
    let folder = Folder::new("calibrate/hall");
    let (arguments, out) = (hall(&folder), folder.path().join("hall.toml"));
    let ran = learn(&arguments, &out, &["--json"]);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let told = ran.json();
    let names: Vec<_> =
        told["classes"].as_array().expect("a list").iter().map(|class| class["class"].as_str()).collect();
    assert_eq!(names, ["orange", "yellow", "blue", "green", "white"].map(Some));
    let orange = &told["classes"][0]["learned"];
    assert_eq!((&orange["images"], &orange["blocks"]), (&6.into(), &5.into()));
    assert!(orange["precision"].as_f64() >= Some(0.99) && orange["recall"].as_f64() >= Some(0.99), "{orange}");
    assert!(told["classes"][1]["learned"].is_null(), "there is no yellow in the labels");
    let text = fs::read_to_string(&out).expect("the profile");
    assert!(text.contains("[orange]\nhue = [") && text.contains("6 images, cross-validated in 5 blocks"), "{text}");
    let labels = folder.path().join("labels.csv");
    let see = ["see", folder.text(), "--profile", out.to_str().expect("UTF-8"), "--score"];
    let ran = run(&[&see[..], &[labels.to_str().expect("UTF-8")]].concat());
    assert!(ran.stdout.contains("6/6 1.000"), "{}", ran.stdout);
}

#[test]
fn the_same_labels_give_the_same_profile() {
    let folder = Folder::new("calibrate/twice");
    let arguments = hall(&folder);
    let profile = |name: &str| {
        let out = folder.path().join(name);
        learn(&arguments, &out, &[]);
        fs::read(out).expect("the profile")
    };
    assert_eq!(profile("a.toml"), profile("b.toml"));
}

#[test]
fn what_cannot_be_learned_from_is_refused_and_named() {
    let folder = Folder::new("calibrate/wrong");
    let arguments = hall(&folder);
    let refused = |args: &[&str], words: &[&str]| {
        let ran = run(args);
        assert_eq!(ran.code, Some(2), "{}", ran.stdout);
        assert!(words.iter().all(|word| ran.stderr.contains(word)), "{}", ran.stderr);
    };
    refused(&["calibrate", folder.text()], &["nothing to learn from", "--rectangles or --labels"]);
    let rectangles = &arguments[5];
    fs::write(rectangles, "file,x0,y0,x1,y1,class\n1.png,1,2,3,4,sky\n").expect("a file");
    let args = ["calibrate", folder.text(), "--rectangles", rectangles];
    refused(&args, &["rectangles.csv", "line 2", "`sky`", "goal_blue"]);
    fs::write(rectangles, "file,x0,y0,x1,y1,class\n1.png,1,2,30,40,field\n").expect("a file");
    fs::write(folder.path().join("1.png"), "no image").expect("a file");
    refused(&args, &["1.png", "mend the image"]);
}

/// The profiles in the repository are what these labels teach.
#[test]
fn the_profiles_of_real_robots_are_learned_again() {
    let Some(images) = real() else { return };
    let outer = Folder::new("calibrate/real");
    let profiles = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../profiles");
    for name in ["nao2009", "darwin2013"] {
        let text = |path: std::path::PathBuf| path.to_str().expect("UTF-8").to_owned();
        let out = outer.path().join(name);
        let ours = text(profiles.join(format!("{name}_rectangles.csv")));
        let (dir, labels) = (text(images.join(name)), text(images.join("labels.csv")));
        let theirs = text(images.join("pixel_classes.csv"));
        let sources = ["--rectangles", &theirs, "--rectangles", &ours, "--labels", &labels, "--out"];
        let ran = run(&[&["calibrate", &dir], &sources[..], &[out.to_str().expect("UTF-8")]].concat());
        println!("{name}:\n{}", ran.stdout);
        let read = |path: &Path| fs::read_to_string(path).expect("a profile");
        assert_eq!(read(&out), read(&profiles.join(format!("{name}.toml"))), "{name}");
    }
}
