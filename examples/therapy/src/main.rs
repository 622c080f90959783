//! The program.

fn main() -> std::process::ExitCode {
    therapy::run()
}
