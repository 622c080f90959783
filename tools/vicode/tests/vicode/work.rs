//! Work beside the loop in the source of a component.

use bica_vicode::model::Input;
use bica_vicode::{Document, Edit, read};
use serde_json::json;

const TEXT: &str = "#[component]
impl A {
    /// A path.
    #[work(takes_ms = 200)]
    fn search(grid: Grid) -> Path {
        grid.path()
    }

    #[state(initial)]
    fn wait(&mut self, work: &mut Work<Self>) {
        work.begin(self.grid);
    }
}
";

#[test]
fn edits_keep_the_function_beside_the_loop() {
    let edits = json!([
        {"edit": "rename", "component": "A", "function": "search", "to": "plan"},
        {"edit": "add_state", "component": "A", "name": "go"},
    ]);
    let mut document = Document::new(TEXT);
    document.apply(&serde_json::from_value::<Vec<Edit>>(edits).unwrap()).unwrap();
    let model = read(document.text());
    let work = &model.components[0].work;
    assert_eq!((work.len(), &*work[0].function.name.text, &*work[0].function.docs.text), (1, "plan", "A path."));
    assert_eq!(work[0].attribute.of(document.text()), "#[work(takes_ms = 200)]");
    assert_eq!(model.components[0].states[0].function.arguments[0].input, Input::Work);
    assert!(document.text().contains("        grid.path()"));
}
