//! Parameters on the command line and in tune files.

use std::fs;

use serde_json::Value;

use crate::process::{Folder, refused, run};

/// Returns the value and the source of `FaceBall.gain`.
fn gain(args: &[&str]) -> (String, Value) {
    let json = run(&[&["params", "FaceBall", "--json"], args].concat()).json();
    assert_eq!(json["schema"], "bica/params/1");
    let rows = json["parameters"].as_array().expect("a list");
    assert!(rows.iter().all(|row| row["component"] == "FaceBall"));
    let gain = rows.iter().find(|row| row["name"] == "gain").expect("a parameter");
    (gain["value"].as_str().expect("a text").to_owned(), gain["source"].clone())
}

#[test]
fn parameters_are_listed_as_table_tune_file_and_json() {
    let table = run(&["params", "FaceBall"]).stdout;
    assert!(table.lines().any(|line| line.starts_with("FaceBall.gain") && line.contains("0.7")), "{table}");
    assert!(!table.contains("FollowBall"), "{table}");
    assert!(run(&["params"]).stdout.contains("FollowBall."));
    let set = &["--set", "FaceBall.gain=0.9"];
    let changed = run(&[&["params", "--changed"][..], set].concat()).stdout;
    assert!(changed.lines().count() == 2 && changed.contains("0.9") && changed.contains("(--set)"), "{changed}");
    let toml = run(&[&["params", "--format", "toml"][..], set].concat()).stdout;
    assert!(toml.contains("[FaceBall]\n") && toml.contains("\ngain = 0.9 # default 0.7, "), "{toml}");
    assert_eq!(gain(set), ("0.9".to_owned(), "--set".into()));
    assert_eq!(gain(&[]), ("0.7".to_owned(), Value::Null));
}

/// Returns the value and the source of a limit of `Colours`.
fn limit(name: &str, args: &[&str]) -> (String, Value) {
    let json = run(&[&["params", "Colours", "--json"], args].concat()).json();
    let rows = json["parameters"].as_array().expect("a list");
    let row = rows.iter().find(|row| row["name"] == name).expect("a parameter");
    (row["value"].as_str().expect("a text").to_owned(), row["source"].clone())
}

#[test]
fn colour_profile_is_a_layer_between_tune_files() {
    let folder = Folder::new("tune-profile");
    fs::write(folder.file("built-in.toml"), "[Colours]\norange_hue_to = 140\ngreen_luma_max = 199\n").unwrap();
    fs::write(folder.file("rob.toml"), "[Colours]\nblue_luma_max = 150\n").unwrap();
    let tune = ["--tune", folder.text(), "--profile", "nao2009"];
    let profile = Value::from("profile nao2009");
    // The values are those of profiles/nao2009.toml.
    assert_eq!(limit("orange_hue_to", &tune), ("145".to_owned(), profile.clone()));
    assert_eq!(limit("green_luma_max", &tune), ("133".to_owned(), profile.clone()));
    assert_eq!(limit("blue_chroma_min", &tune), ("21".to_owned(), profile.clone()));
    assert_eq!(limit("white_saturation_max", &tune), ("8".to_owned(), profile));
    let robot = [&tune[..], &["--robot", "rob", "--set", "Colours.blue_luma_min=60"]].concat();
    assert_eq!(limit("blue_luma_max", &robot).0, "150");
    assert_eq!(limit("blue_luma_min", &robot), ("60".to_owned(), "--set".into()));
    assert_eq!(limit("blue_hue_from", &robot).0, "282");
}

#[test]
fn colour_profile_becomes_an_equal_tune_file() {
    let folder = Folder::new("tune-convert");
    for profile in ["nao2009", "darwin2013"] {
        let file = folder.file(&format!("{profile}.toml"));
        assert_eq!(run(&["params", "--profile", profile, "--write", &file]).code, Some(0));
        let values = |args: &[&str]| {
            let json = run(&[&["params", "Colours", "--json"], args].concat()).json();
            let rows = json["parameters"].as_array().expect("a list").iter();
            rows.map(|row| (row["name"].clone(), row["value"].clone())).collect::<Vec<_>>()
        };
        let direct = values(&["--profile", profile]);
        assert_eq!(values(&["--tune", folder.text(), "--kind", profile]), direct);
        assert_ne!(values(&[]), direct);
    }
    assert_eq!(run(&["params", "--profile", "built-in", "--changed"]).stdout.lines().count(), 1, "only the titles");
}

#[test]
fn inexpressible_profile_is_refused() {
    let folder = Folder::new("tune-inexpressible");
    let file = folder.file("hall.toml");
    let of_profile = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../profiles/nao2009.toml")).unwrap();
    let changed = |from: &str, to: &str, words: &[&str]| {
        assert!(of_profile.contains(from), "{from}");
        fs::write(&file, of_profile.replace(from, to)).unwrap();
        refused(&["params", "--profile", &file], words);
    };
    changed("hue = [119, 145]", "", &["hall.toml", "`orange` has no range of hues", "hue = [from, to]"]);
    changed("saturation = [22, 400]", "", &["`orange` has no range of saturations"]);
    changed("saturation = [22, 400]", "saturation = [22, 1001]", &["profile", "orange_saturation_max", "0 to 1000"]);
    changed("saturation = [0, 8]", "saturation = [1, 8]", &["`white` has other limits"]);
    changed("hue = [119, 145]", "hue = [119]", &["line", "`hue = [119]`"]);
    refused(&["params", "--profile", "nao2010"], &["nao2010", "built-in, nao2009 and darwin2013"]);
}

#[test]
fn wrong_layers_are_errors_of_every_command() {
    let folder = Folder::new("tune-errors");
    fs::write(folder.file("built-in.toml"), "[FaceBall]\ngain = 0.5\n").unwrap();
    let missing = folder.file("missing.toml");
    for command in [&["play", "--seconds", "0.1"][..], &["params"]] {
        for (args, words) in [
            (&["--set", "FaceBall.gian=0.5"][..], &["`gian`", "did you mean `gain`?"][..]),
            (&["--tune", folder.text(), "--robot", "rob"], &["help: "]),
            (&["--robot", "rob"], &["rob.toml", "--write"]),
            (&["--tune", &missing], &[&format!("`{missing}`"), "--write"]),
            (&["--tune", &missing, "--robot", "rob"], &[&format!("`{missing}`"), "--write"]),
        ] {
            refused(&[command, args].concat(), words);
        }
    }
    refused(&["params", "FaceBal"], &["did you mean `FaceBall`?"]);
    refused(&["--world", "firmware", "--set", "FaceBall.gain=0.5"], &["help: "]);
}
