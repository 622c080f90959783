//! The workspace's chores: `cargo xtask` lists them.

mod buildtime;
mod firmware;
mod fuzz;
mod instructions;
mod mujoco;
mod no_std;
mod opencv;
mod peers;
mod process;

use std::process::ExitCode;

const HELP: &str = "\
Chores of the BICA workspace.

  cargo xtask no-std    builds what runs on a robot for thumbv7em-none-eabihf, and links the forward without a heap;
                        gets the target first (rustup, else Debian's Rust and a build of `core` from source)
  cargo xtask firmware  builds the image for the microcontroller, boots it in QEMU, and plays games of which every
                        cycle is thought on the host too; holds size, stack and instructions to their limits
                        (--build: only builds; --size: what takes how much; --bless: takes the new figures as right;
                        --fuzz: damages the link for twice ten minutes)
  cargo xtask mujoco    installs what the feature `mujoco` needs: MuJoCo's library into target/mujoco (from PyPI, with pip), and
                        EGL with Mesa's software renderer (with apt); `play --world mujoco` plays there
  cargo xtask budget    counts the instructions of the benchmarks that are gated, by valgrind, and holds each within 2 % of
                        benches/instructions.txt; gets valgrind (with apt) and gungraun-runner (built once) first
                        (--bless: takes the new counts as right)
  cargo xtask buildtime measures what one waits for the compiler: a change to a component until its test has run, and a
                        clean build of the facade (--limit SECONDS: what each may take, to see it fail)
  cargo xtask fuzz      feeds any frames from any cameras to the eyes, and any bytes to the decoder of the robot's link;
                        fetches cargo-fuzz into target/ (--seconds N: for each of the two, instead of 60)
  cargo xtask opencv    the eyes beside OpenCV on the same frames, one core, in turn; fetches OpenCV into target/
                        (needs Python 3), and fails unless the eyes take a tenth of the time or less
  cargo xtask peers     does the same work in BICA and its peers (copper-rs, statig, smlang, …), timed beside each other,
                        and fails if a promise about speed is broken (--quick: a look; --slow: BICA slower on purpose)
  cargo xtask ci        all that CI checks: format, lints, docs, tests, twenty games, instructions, MuJoCo,
                        no-std, firmware
";

fn main() -> ExitCode {
    let mut words = std::env::args().skip(1);
    let result = match (words.next().as_deref(), words.next()) {
        (Some("no-std"), None) => no_std::check(),
        (Some("firmware"), None) => firmware::check(None),
        (Some("firmware"), Some(more)) if ["--build", "--size", "--bless", "--fuzz"].contains(&more.as_str()) => {
            firmware::check(Some(&more))
        }
        (Some("mujoco"), None) => mujoco::install(),
        (Some("budget"), None) => instructions::check(false),
        (Some("budget"), Some(more)) if more == "--bless" => instructions::check(true),
        (Some("buildtime"), None) => buildtime::check(None),
        (Some("buildtime"), Some(more)) if more == "--limit" => {
            buildtime::check(Some(&words.next().unwrap_or_default()))
        }
        (Some("fuzz"), None) => fuzz::check(fuzz::SECONDS),
        (Some("fuzz"), Some(more)) if more == "--seconds" => fuzz::check(&words.next().unwrap_or_default()),
        (Some("opencv"), None) => opencv::compare(),
        (Some("peers"), None) => peers::measure(None),
        (Some("peers"), Some(option)) if peers::OPTIONS.contains(&option.as_str()) => peers::measure(Some(&option)),
        (Some("ci"), None) => ci(),
        (None | Some("help" | "--help" | "-h"), None) => {
            print!("{HELP}");
            return ExitCode::SUCCESS;
        }
        (chore, rest) => {
            let words: Vec<String> = chore.map(str::to_owned).into_iter().chain(rest).chain(words).collect();
            eprintln!("`{}` is no chore.\n\n{HELP}", words.join(" "));
            return ExitCode::from(2);
        }
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("xtask: {error}");
            ExitCode::FAILURE
        }
    }
}

fn ci() -> Result<(), String> {
    use process::run;
    run("cargo", &["fmt", "--all", "--check"], &[])?;
    run("cargo", &["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"], &[])?;
    run("cargo", &["doc", "--workspace", "--no-deps"], &[("RUSTDOCFLAGS", "-D warnings")])?;
    run("cargo", &["test", "--workspace"], &[])?;
    peers::check()?;
    run("cargo", &["run", "--release", "--", "play", "--games", "20", "--at-least", "19"], &[])?;
    instructions::check(false)?;
    mujoco::check()?;
    no_std::check()?;
    firmware::check(None)
}
