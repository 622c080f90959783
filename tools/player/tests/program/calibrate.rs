//! Profiles fitted to labelled images.

use std::fs;
use std::path::Path;

use crate::process::{Folder, refused, run};
use crate::test_image::{self, ORANGE, RED};

/// Writes images, each with a ball and a red disc, and their labels; returns the arguments of a calibration.
fn training_data(folder: &Folder) -> Vec<String> {
    let mut labels = vec!["file,ball_x,ball_y,ball_radius,ball_flag,goal".to_owned()];
    let mut rectangles = vec!["file,x0,y0,x1,y1,class".to_owned()];
    for index in 0..6 {
        let (x, name) = (60 + 30 * index, format!("{index}.png"));
        test_image::png(&folder.path().join(&name), &test_image::rgb(&[(x, 150, 14, ORANGE), (x, 200, 16, RED)]));
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

fn calibrate(arguments: &[String], out: &Path, more: &[&str]) -> crate::process::Ran {
    let arguments = arguments.iter().map(String::as_str);
    run(&arguments.chain([out.to_str().expect("UTF-8")]).chain(more.iter().copied()).collect::<Vec<_>>())
}

#[test]
fn a_fitted_profile_detects_the_ball() {
    let folder = Folder::new("calibrate/hall");
    let (arguments, out) = (training_data(&folder), folder.path().join("hall.toml"));
    let ran = calibrate(&arguments, &out, &["--json"]);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let printed = ran.json();
    let names: Vec<_> =
        printed["classes"].as_array().expect("a list").iter().map(|class| class["class"].as_str()).collect();
    assert_eq!(names, ["orange", "yellow", "blue", "green", "white"].map(Some));
    let orange = &printed["classes"][0]["learned"];
    assert_eq!((&orange["images"], &orange["blocks"]), (&6.into(), &5.into()));
    let above = |key: &str| orange[key].as_f64().is_some_and(|share| share >= 0.99);
    assert!(above("precision") && above("recall"), "{orange}");
    assert!(printed["classes"][1]["learned"].is_null(), "there is no yellow in the labels");
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
    let arguments = training_data(&folder);
    let profile = |name: &str| {
        let out = folder.path().join(name);
        calibrate(&arguments, &out, &[]);
        fs::read(out).expect("the profile")
    };
    assert_eq!(profile("a.toml"), profile("b.toml"));
}

#[test]
fn errors_name_the_wrong_input() {
    let folder = Folder::new("calibrate/wrong");
    let arguments = training_data(&folder);
    refused(&["calibrate", folder.text()], &["no labels", "--rectangles or --labels"]);
    let rectangles = &arguments[5];
    fs::write(rectangles, "file,x0,y0,x1,y1,class\n1.png,1,2,3,4,sky\n").expect("a file");
    let args = ["calibrate", folder.text(), "--rectangles", rectangles];
    refused(&args, &["rectangles.csv", "line 2", "`sky`", "goal_blue"]);
    fs::write(rectangles, "file,x0,y0,x1,y1,class\n1.png,1,2,30,40,field\n").expect("a file");
    fs::write(folder.path().join("1.png"), "no image").expect("a file");
    refused(&args, &["1.png", "repair the image"]);
}

bica_test_data::images_test! {
    fn profiles_are_reproduced_from_the_images() {
        let images = bica_test_data::images();
        let outer = Folder::new("calibrate/real");
        let profiles = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../profiles");
        for name in ["nao2009", "darwin2013"] {
            let text = |path: std::path::PathBuf| path.to_str().expect("UTF-8").to_owned();
            let out = outer.path().join(name);
            let own = text(profiles.join(format!("{name}_rectangles.csv")));
            let (dir, labels) = (text(images.join(name)), text(images.join("labels.csv")));
            let other = text(images.join("pixel_classes.csv"));
            let sources = ["--rectangles", &other, "--rectangles", &own, "--labels", &labels, "--out"];
            let ran = run(&[&["calibrate", &dir], &sources[..], &[out.to_str().expect("UTF-8")]].concat());
            println!("{name}:\n{}", ran.stdout);
            let read = |path: &Path| fs::read_to_string(path).expect("a profile");
            assert_eq!(read(&out), read(&profiles.join(format!("{name}.toml"))), "{name}");
        }
    }
}
