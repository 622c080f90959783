//! Templates: files of a new crate. The pages of `docs/` show the same texts.

use std::fs;
use std::path::Path;

use bica_app::Failure;

/// Path of the BICA checkout in the templates.
const CHECKOUT: &str = "../bica";

/// Files of a crate.
pub(crate) struct Template {
    /// Name of the crate in the template's texts.
    name: &'static str,
    pub(crate) manifest: &'static str,
    /// Further files: path and text.
    files: &'static [(&'static str, &'static str)],
    /// Files that are copied from the checkout: path in the crate and path in the checkout.
    copies: &'static [(&'static str, &'static str)],
    /// Command that the user runs first.
    pub(crate) run: &'static str,
}

/// Template of the cart in `docs/your-robot.md`.
pub(crate) const CART: Template = Template {
    name: "cart",
    manifest: include_str!("../template/cart/manifest.toml"),
    files: &[
        ("src/lib.rs", include_str!("../template/cart/lib.rs")),
        ("src/main.rs", include_str!("../template/cart/main.rs")),
        ("benches/budgets.rs", include_str!("../template/cart/budgets.rs")),
        ("tune/road.toml", include_str!("../template/cart/road.toml")),
        (".gitignore", include_str!("../template/cart/gitignore")),
        (".github/workflows/ci.yml", include_str!("../template/cart/ci.yml")),
        ("README.md", include_str!("../template/cart/README.md")),
    ],
    copies: &[],
    run: "cargo run",
};

/// Template of the firmware in `docs/firmware.md`.
pub(crate) const EMBASSY: Template = Template {
    name: "my-robot",
    manifest: include_str!("../template/embassy/manifest.toml"),
    files: &[
        (".cargo/config.toml", include_str!("../template/embassy/config.toml")),
        ("src/main.rs", include_str!("../template/embassy/main.rs")),
        (".gitignore", include_str!("../template/cart/gitignore")),
        ("README.md", include_str!("../template/embassy/README.md")),
    ],
    copies: &[("memory.x", "firmware/boards/an500/memory.x"), ("src/clock.rs", "firmware/boards/an500/clock.rs")],
    run: "cargo run --release",
};

/// Template of the humanoid in `docs/new-robot.md`.
pub(crate) const HUMANOID: Template = Template {
    name: "biped",
    manifest: include_str!("../template/humanoid/manifest.toml"),
    files: &[
        (".cargo/config.toml", include_str!("../template/humanoid/config.toml")),
        ("build.rs", include_str!("../template/humanoid/build.rs")),
        ("src/lib.rs", include_str!("../template/humanoid/lib.rs")),
        ("src/main.rs", include_str!("../template/humanoid/main.rs")),
        ("src/model.rs", include_str!("../template/humanoid/model.rs")),
        ("src/world.rs", include_str!("../template/humanoid/world.rs")),
        ("benches/budgets.rs", include_str!("../template/humanoid/budgets.rs")),
        (".gitignore", include_str!("../template/cart/gitignore")),
        (".github/workflows/ci.yml", include_str!("../template/cart/ci.yml")),
        ("README.md", include_str!("../template/humanoid/README.md")),
    ],
    copies: &[("robot.xml", "bica-motion/models/k1/robot.xml"), ("robot.xml.LICENSE", "bica-motion/models/k1/LICENSE")],
    run: "cargo run",
};

impl Template {
    /// Returns path and text of each file for a crate with this name; `checkout` is the path from the crate to the checkout.
    ///
    /// # Errors
    /// If a file of the checkout cannot be read.
    pub(crate) fn files(&self, name: &str, checkout: &str, repository: &Path) -> Result<Vec<(&str, String)>, Failure> {
        let copied = self.copies.iter().map(|(path, from)| {
            let from = repository.join(from);
            let text = fs::read_to_string(&from);
            Ok((
                *path,
                text.map_err(|error| Failure::of_path("read", &from, &error, "restore it from the repository"))?,
            ))
        });
        let own = [("Cargo.toml", self.manifest)].into_iter().chain(self.files.iter().copied());
        own.map(|(path, text)| Ok((path, self.named(text, name, checkout)))).chain(copied).collect()
    }

    /// Replaces the template's name by another one: the names of the package, of the crate in code, of the program and of the robot.
    fn named(&self, text: &str, name: &str, checkout: &str) -> String {
        let old = self.name;
        text.replace(CHECKOUT, checkout)
            .replace(&format!("name = \"{old}\""), &format!("name = \"{name}\""))
            .replace(&format!("id: \"{old}\""), &format!("id: \"{name}\""))
            .replace(&format!("new(\"{old}\")"), &format!("new(\"{name}\")"))
            .replace(&format!("{old}::app()"), &format!("{}::app()", name.replace('-', "_")))
            .replace(&format!("# {old}\n"), &format!("# {name}\n"))
    }
}
