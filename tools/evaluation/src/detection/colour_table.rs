//! Colour classification.

use std::fs;
use std::path::Path;

use bica_app::Failure;
use bica_vision::table::{CompactTable, FULL_BYTES};

use crate::profile;

/// Colour table.
#[derive(Debug)]
pub enum ColourTable {
    /// Table compiled from thresholds.
    Compact(Box<CompactTable>),
    /// Full table in the format of other teams.
    Full(Box<[u8; FULL_BYTES]>),
}

impl ColourTable {
    /// Loads a profile by its name or from a TOML file, or a table from a file that ends in `.bin`.
    ///
    /// # Errors
    /// If the file cannot be read or is malformed.
    pub fn load(name: &str) -> Result<Self, Failure> {
        if Path::new(name).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("bin")) {
            return table(Path::new(name));
        }
        Ok(Self::Compact(Box::new(CompactTable::compile(&profile::load(name)?))))
    }
}

fn table(path: &Path) -> Result<ColourTable, Failure> {
    let help =
        "a table has 64×64×64 bytes, index [Y>>2][Cb>>2][Cr>>2]: 0 none, 1 orange, 2 yellow, 3 blue, 4 white, 5 green";
    let bytes = fs::read(path).map_err(|error| Failure::of_path("read the table", path, &error, help))?;
    let found = bytes.len();
    let cells = bytes.into_boxed_slice().try_into().map_err(|_| {
        Failure::new(format!("`{}` is not a colour table: {found} bytes, not {FULL_BYTES}", path.display()), help)
    })?;
    Ok(ColourTable::Full(cells))
}
