//! Wrong arguments: exit code 2, nothing on stdout, and a message with the mistake and the remedy.

#[cfg(feature = "evaluation")]
use crate::process::Folder;
use crate::process::{self, run};

fn refused(args: &[&str], words: &[&str]) {
    assert_eq!(process::refused(args, words).stdout, "", "{args:?}");
}

#[test]
fn errors_name_the_wrong_argument_and_the_valid_ones() {
    refused(&["kick"], &["kick", "Usage"]);
    refused(&["--sed", "1"], &["--sed", "--seed"]);
    refused(&["--seed", "one"], &["one", "--seed"]);
    refused(&["--seed", "-1"], &["-1"]);
    refused(&["--size", "321x240"], &["321x240", "160x120, 320x240 or 640x480"]);
    refused(&["--robots", "9"], &["9", "from 0 to 8"]);
    refused(&["--seconds", "0"], &["--seconds", "from 0.01 to 86400"]);
    refused(&["--seconds", "NaN"], &["NaN", "from 0.01 to 86400"]);
    refused(&["--seconds", "-1"], &["--seconds", "from 0.01 to 86400"]);
    refused(&["--image", "forward.elf"], &["--image", "--world firmware"]);
    refused(&["--option", "image=blue"], &["image", "freeze, dark, bright, noise or drop"]);
    refused(&["--option", "speed=3"], &["`built-in` has no option `speed`"]);
    refused(&["--option", "ball=1"], &["ball has 1 numbers", "give 2 or 4"]);
    refused(&["--option", "gyro=NaN"], &["gyro=NaN", "finite numbers"]);
    for (option, range) in [
        ("gyro=1e30", "from -35 to 35"),
        ("ball=1,0,1e30,0", "from -10 to 10"),
        ("mounting=0,0,9", "from -0.5 to 0.5"),
        ("button=-1", "from 0 to 86400"),
    ] {
        refused(&["--option", option], &["out of range", range]);
    }
    refused(&["--option", "from=5"], &["no fault in this time", "image=freeze"]);
    refused(&["--option", "image=dark", "--option", "from=5", "--option", "until=2"], &["`from` before `until`"]);
    refused(&["--option", "stuck=Nose"], &["stuck=Nose", "HeadYaw"]);
    refused(&["--option", "robot=9,0,0"], &["the robot cannot start at (9, 0)"]);
    refused(&["--games", "0"], &["--games"]);
    refused(&["--threads", "2"], &["--games"]);
    refused(&["play", "--games", "2", "--threads", "0"], &["--threads"]);
    refused(&["play", "--at-least", "1"], &["--games"]);
    refused(&["graph", "--format", "bmp"], &["bmp", "svg, dot, mermaid, json"]);
    refused(&["graph", "--format", "dot", "--json"], &["--format", "--json"]);
    #[cfg(feature = "evaluation")]
    refused(&["watch"], &["DIR"]);
}

#[cfg(not(feature = "evaluation"))]
#[test]
fn errors_name_the_feature_that_the_program_lacks() {
    for args in
        [&["watch", "frames", "--json"][..], &["trial"], &["--film", "game.gif"], &["play", "--pictures", "album"]]
    {
        refused(args, &["built without", "--features evaluation"]);
    }
    #[cfg(not(feature = "booster"))]
    refused(&["play", "--world", "booster", "--robot", "t1"], &["built without", "--features booster"]);
    #[cfg(not(feature = "league"))]
    refused(&["play", "--world", "league"], &["built without", "--features league"]);
    #[cfg(not(feature = "lola"))]
    refused(&["play", "--world", "lola"], &["built without", "--features lola"]);
}

#[cfg(feature = "booster")]
#[test]
fn mistakes_about_a_booster_are_refused() {
    for (args, words) in [
        (&["--world", "booster"][..], &["--robot t1", "--robot k1"][..]),
        (&["--world", "booster", "--robot", "nao"], &["--robot t1", "--robot k1"]),
        (&["--world", "booster", "--robot", "t1", "--dds-domain", "233"], &["233", "0..=232"]),
        (&["--world", "booster", "--robot", "t1", "--dds-interface", "nowhere0"], &["nowhere0", "ip address"]),
        (&["--world", "booster", "--robot", "t1", "--games", "2"], &["--games"]),
        (&["--gait", "firmware"], &["--world booster"]),
    ] {
        refused(&[&["play"], args].concat(), words);
    }
}

#[cfg(feature = "evaluation")]
#[test]
fn errors_name_the_folder_that_cannot_be_written() {
    let folder = Folder::new("arguments");
    let file = folder.path().join("file");
    std::fs::write(&file, "").unwrap();
    let file = file.to_str().unwrap();
    refused(&["--seconds", "0.1", "--pictures", file], &[file, "help: "]);
    refused(&["--seconds", "0.1", "--games", "2", "--pictures", file], &[file, "help: "]);
}

#[test]
fn help_has_examples_and_exit_codes() {
    for (args, word) in [
        (&["--help"][..], "player play --games 100"),
        (&["--help"], "Exit codes: 0 a goal"),
        (&["play", "--help"], "the same seed gives the same game"),
        (&["graph", "--help"], "Graphviz"),
        #[cfg(feature = "evaluation")]
        (&["watch", "--help"], "in the order of their names"),
        (&["--version"], env!("CARGO_PKG_VERSION")),
    ] {
        let ran = run(args);
        assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""), "{args:?}");
        assert!(ran.stdout.contains(word), "{args:?} lacks `{word}`:\n{}", ran.stdout);
    }
}
