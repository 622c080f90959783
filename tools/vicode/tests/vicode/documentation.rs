//! Agreement of `docs/vicode.md` with the library.

use bica_vicode::Edit;

use crate::sources;

#[test]
fn example_on_the_page_is_valid() {
    let page = sources::text("docs/vicode.md");
    let json = page.split("```json\n").nth(1).and_then(|rest| rest.split("```").next()).expect("an example");
    let edits: Vec<Edit> = serde_json::from_str(json).expect("edits");
    assert_eq!(edits.len(), 5);
    assert_eq!(serde_json::from_str::<Vec<Edit>>(&serde_json::to_string(&edits).unwrap()).unwrap(), edits);
}

#[test]
fn page_lists_every_edit_and_field() {
    let page = sources::text("docs/vicode.md");
    let unknown = serde_json::from_str::<Edit>(r#"{"edit": "none"}"#).unwrap_err().to_string();
    let names: Vec<&str> = unknown.split('`').skip(3).step_by(2).collect();
    assert_eq!(names.len(), 33, "{unknown}");
    for name in names {
        assert!(page.contains(&format!("| `{name}` | `")), "{name}");
        let row = page.lines().find(|line| line.starts_with(&format!("| `{name}` "))).unwrap();
        let fields = row.split('|').nth(2).unwrap();
        let required: Vec<&str> = fields.split('(').next().unwrap().split('`').skip(1).step_by(2).collect();
        // An edit without fields is refused because of its first required field, which is the first in the list.
        let missing = serde_json::from_str::<Edit>(&format!(r#"{{"edit": "{name}"}}"#)).unwrap_err().to_string();
        assert!(missing.contains(&format!("missing field `{}`", required[0])), "{name}: {missing}");
    }
}
