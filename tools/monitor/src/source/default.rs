//! Defaults of parameters in their sources, set to tuned values.

use bica_link::{Param, Plain};
use bica_vicode::cli::unified;
use bica_vicode::model::{Input, Model};
use bica_vicode::{Edit, read, reads};
use serde_json::{Value, json};

use super::edit;
use super::files::Files;
use super::search::use_at;
use crate::pages::PageId;
use crate::protocol::{ChangedBy, Failed, SourceUse};

impl Files {
    /// Writes the current value of a parameter to its source, as the new default.
    pub(super) fn set_default(&self, page: PageId, component: &str, param: &Param) -> Result<Value, Failed> {
        let name = self.file_of(component, param)?;
        let (before, after) = {
            let mut open = self.open();
            let file = self.get(&mut open, &name)?;
            let (before, from) = (file.document.text().to_owned(), file.document.version());
            let written = default_of(file.document.model(), param).unwrap_or_default();
            let value = literal(param, &written);
            let (parameters, parameter) = (param.group.clone(), param.name.clone());
            let change = edit::apply(file, &[Edit::SetDefault { parameters, parameter, value }])?;
            file.publish(&self.pages, Some((from, change)), ChangedBy::Page, page);
            (before, file.document.text().to_owned())
        };
        self.write(&name)?;
        Ok(json!({ "path": name, "diff": unified(&name, &before, &after) }))
    }

    /// Lists where a parameter is declared and read. If several structs have the name of its struct, only the one in the
    /// component's file counts.
    pub(super) fn param_uses(&self, component: &str, param: &Param) -> Vec<SourceUse> {
        let home = self.file_of(component, param).ok();
        let mut list = Vec::new();
        for (name, _) in self.all() {
            let Ok(text) = self.text(&name) else { continue };
            let is_other =
                || home.as_ref().is_some_and(|home| *home != name) && read(&text).group(&param.group).is_some();
            if !text.contains(&param.name) || !text.contains(&param.group) || is_other() {
                continue;
            }
            list.extend(
                reads(&text, &param.group, &param.name).into_iter().map(|span| use_at(&name, &text, span, true)),
            );
        }
        list
    }

    /// Returns the file with the parameter's struct; if there are several, the one that also has the component.
    fn file_of(&self, component: &str, param: &Param) -> Result<String, Failed> {
        let mut found: Vec<(String, bool)> = Vec::new();
        for (name, _) in self.all() {
            let Ok(text) = self.text(&name) else { continue };
            if !text.contains(&param.group) || !text.contains("Params") {
                continue;
            }
            let model = read(&text);
            if default_of(&model, param).is_some() {
                found.push((name, has_component(&model, component, &param.group)));
            }
        }
        if found.iter().any(|(_, own)| *own) {
            found.retain(|(_, own)| *own);
        }
        let what = format!("parameter `{}` of `{}`", param.name, param.group);
        match &found[..] {
            [(name, _)] => Ok(name.clone()),
            [] => Err(Failed::new(
                format!("no file below the folder of sources has the {what} with a `default`"),
                "start the server with --source and the folder of this robot's program, or write the default by hand",
            )),
            several => {
                let names: Vec<&str> = several.iter().map(|(name, _)| name.as_str()).collect();
                Err(Failed::new(
                    format!("several files have the {what}: {}", names.join(", ")),
                    "start the server with --source and a smaller folder, or write the default by hand",
                ))
            }
        }
    }
}

fn has_component(model: &Model, component: &str, group: &str) -> bool {
    let is_tuned = |input: &Input| matches!(input, Input::Tuned { parameters } if parameters == group);
    model.components.iter().any(|one| {
        one.name.text.split('<').next() == component.split('<').next()
            && one.functions().flat_map(|function| &function.arguments).any(|argument| is_tuned(&argument.input))
    })
}

/// Returns the default of a parameter as written in the source.
fn default_of(model: &Model, param: &Param) -> Option<String> {
    let group = model.group(&param.group)?;
    let found = group.parameters.iter().find(|one| one.name.text == param.name)?;
    found.value("default").map(|value| value.text.clone())
}

/// Returns the current value as Rust code; `written` is the default that it replaces.
fn literal(param: &Param, written: &str) -> String {
    let value = param.current();
    match param.plain(value) {
        Plain::Name(name) => match written.rsplit_once("::") {
            Some((path, _)) => format!("{}::{name}", path.trim_end()),
            None => name,
        },
        _ => param.kind.text(value).to_string(),
    }
}
