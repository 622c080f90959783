//! `vicode check`

use std::io::Write;
use std::path::Path;

use super::{place, print, print_json, text_of};

pub(super) fn run(file: &Path, json: bool, out: &mut dyn Write) -> Result<bool, String> {
    let text = text_of(file)?;
    let problems = crate::read(&text).problems;
    if json {
        print_json(out, &problems)?;
        return Ok(problems.is_empty());
    }
    for problem in &problems {
        let (line, column) = place(&text, problem.span.start);
        print(out, &format!("{}:{line}:{column}: {}\n", file.display(), problem.message))?;
    }
    Ok(problems.is_empty())
}
