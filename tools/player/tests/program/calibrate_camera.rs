//! Tests of `player calibrate-camera`.

use serde_json::Value;

use crate::process::{Folder, player, refused, run};

/// Records a robot that stands on the mark before the goal and moves its head, with an error of its cameras, rad.
fn record(folder: &Folder, mounting: &str) -> String {
    let file = folder.file("head.mcap");
    let options = ["robot=1.2,0,0", "ball=-2.5,1.5", mounting].map(|option| ["--option", option]).concat();
    let run = ["play", "--seconds", "4.5", "--record", &file];
    assert_eq!(player(&[&run[..], &options].concat()).output().expect("it runs").status.code(), Some(1));
    file
}

#[test]
fn error_of_cameras_is_found_in_a_recording() {
    let folder = Folder::new("calibrate-camera/found");
    let file = record(&folder, "mounting=0.035,0.045,-0.04");
    let out = folder.file("nao.toml");
    let ran = run(&["calibrate-camera", &file, "--pose", "1.2,0,0", "--out", &out, "--json"]);
    let found: Value = serde_json::from_str(&ran.stdout).unwrap_or_else(|_| panic!("{}", ran.stderr));
    for (index, angle) in [0.035, 0.045, -0.04].into_iter().enumerate() {
        let error = found["top"][index].as_f64().expect("an angle") - angle;
        assert!(error.abs() < 0.3_f64.to_radians(), "{found}");
    }
    let figure = |when: &str, name: &str| found[when][name].as_f64().expect("a figure");
    assert!(figure("after", "rms_px") < 0.5 * figure("before", "rms_px"), "{found}");
    let params = run(&["params", "CameraPose", "--tune", folder.text(), "--robot", "nao", "--json"]);
    assert!(params.stdout.contains("nao.toml"), "the player applies it: {}", params.stdout);
    refused(&["calibrate-camera", &file, "--pose", "0.3,0.5,0.4"], &["the best angles", "--pose"]);
    refused(&["calibrate-camera", &file, "--pose", "1.2,0,0", "--out", &out], &["exists", "--force"]);
}

#[test]
fn recordings_without_lines_are_refused() {
    let folder = Folder::new("calibrate-camera/blind");
    let file = folder.file("dark.mcap");
    let run = ["play", "--seconds", "1", "--size", "160x120", "--option", "image=dark", "--record", &file];
    assert_eq!(player(&run).output().expect("it runs").status.code(), Some(1));
    refused(&["calibrate-camera", &file, "--pose", "1.2,0,0"], &["0 images show lines", "--profile"]);
    refused(&["calibrate-camera", &file, "--pose", "1.2,0"], &["x, y and heading"]);
    refused(&["calibrate-camera", "/nowhere.mcap", "--pose", "1.2,0,0"], &["/nowhere.mcap"]);
}
