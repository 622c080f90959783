//! Tables of numbers: keyframes of motions.

use std::fs;

use bica_vicode::model::Table;
use bica_vicode::{Document, Edit, NewNumber, read};

use super::keeping::edited;
use super::sources::{files, root, text};

/// Types of rows of the repository's motions.
const MOTIONS: [&str; 5] = ["GetUpFrame", "KickFrame", "Keyframe", "Key", "Joints"];

#[test]
fn the_motions_of_the_repository_are_found() {
    let names = |path: &str| -> Vec<String> {
        let tables = read(&text(path)).tables.into_iter().filter(|table| MOTIONS.contains(&&*table.ty));
        tables.map(|table| format!("{} {} {}", table.key, table.ty, table.rows.len())).collect()
    };
    let getup = names("bica-motion/src/model/nao/getup.rs");
    assert_eq!(getup[..2], ["SIT_UP_FROM_FRONT GetUpFrame 14", "SIT_UP_FROM_BACK GetUpFrame 4"]);
    assert_eq!(getup.len(), 5);
    let kicks = names("bica-motion/src/model/nao/kick_dynamic.rs");
    assert_eq!(kicks, ["FRONT KickFrame 7", "DIAGONAL KickFrame 8", "LATERAL KickFrame 7"]);
    let postures = names("bica-motion/src/model/nao/postures.rs");
    assert_eq!(postures, ["STAND Joints 1", "SIT Joints 1", "TO_STAND Keyframe 1", "TO_SIT Keyframe 1"]);
    assert_eq!(names("bica-motion/src/model/t1.rs")[..2], ["STAND Joints 1", "TO_STAND Keyframe 1"]);
    let therapy = names("examples/therapy/src/body/keys.rs");
    assert_eq!((therapy.len(), &*therapy[3]), (7, "TouchShoulder Key 4"));
}

/// A number with another last digit.
fn next(written: &str, value: f64) -> f64 {
    let places = written.split_once('.').map_or(0, |(_, fraction)| fraction.replace('_', "").len());
    (value + 10_f64.powi(-(places as i32))) * if value < 0.0 { 1.0 } else { -1.0 }
}

#[test]
fn each_motion_is_written_back_byte_for_byte() {
    let mut number = 0;
    for path in files(&root()) {
        let Ok(text) = fs::read_to_string(&path) else { continue };
        if !MOTIONS.iter().any(|ty| text.contains(ty)) {
            continue;
        }
        let is_motion = |table: &&Table| MOTIONS.contains(&&*table.ty);
        for table in read(&text).tables.iter().filter(is_motion) {
            number += 1;
            let (path, key) = (path.display(), &table.key);
            let mut document = Document::new(&text);
            let cells =
                table.rows.iter().enumerate().flat_map(|(row, one)| one.cells.iter().map(move |cell| (row, cell)));
            let cells = cells.filter_map(|(row, cell)| Some((row, cell, cell.value?)));
            let set = |document: &mut Document, change: &dyn Fn(&str, f64) -> f64| {
                let numbers = cells.clone().map(|(row, cell, value)| {
                    let value = Some(change(cell.span.of(&text), value));
                    NewNumber { row, cell: cell.name.clone(), value }
                });
                let edit = Edit::SetNumbers { table: key.clone(), numbers: numbers.collect() };
                document.apply(&[edit]).unwrap_or_else(|refusal| panic!("{path} {key}: {refusal}"));
            };
            set(&mut document, &|_, value| value);
            assert_eq!(document.version(), 0, "{path} {key}: the same numbers change nothing");
            set(&mut document, &next);
            assert_ne!(document.text(), text, "{path} {key}");
            set(&mut document, &|_, value| value);
            assert_eq!(document.text(), text, "{path} {key}: numbers");
            if table.array.is_none() {
                continue;
            }
            let is_flat = table.array.is_some_and(|array| !array.of(&text).contains('\n'));
            for before in 0..=table.rows.len() {
                let (table, copy) = (key.clone(), Some(before.saturating_sub(1)));
                let insert = Edit::InsertRow { table: table.clone(), before, copy, code: String::new() };
                document.apply(&[insert]).unwrap_or_else(|refusal| panic!("{path} {key}: {refusal}"));
                if is_flat && document.text().lines().count() > text.lines().count() {
                    // The line of the array became too long, so each row has a line now.
                    document.undo();
                    assert_eq!(document.text(), text, "{path} {key}: row {before}");
                    continue;
                }
                document.apply(&[Edit::DeleteRow { table, row: before }]).expect("a row that was inserted");
                assert_eq!(document.text(), text, "{path} {key}: row {before}");
            }
        }
    }
    assert!(number >= 30, "{number} motions");
}

#[test]
fn a_number_keeps_the_form_of_the_one_before() {
    for (old, value, new) in [
        ("36", 40.4, "40"),
        ("0.40", 0.5, "0.50"),
        ("0.4", -0.0, "0.0"),
        ("6.990_085", 7.5, "7.500_000"),
        ("-1.0", -0.123_456_78, "-0.123457"),
        ("2.", 3.0, "3."),
    ] {
        let text = |number: &str| format!("const ONE: Frame = Frame {{ seconds: {number} }};\n");
        let mut document = Document::new(&text(old));
        let numbers = vec![NewNumber { row: 0, cell: "seconds".to_owned(), value: Some(value) }];
        document.apply(&[Edit::SetNumbers { table: "ONE".to_owned(), numbers }]).expect("a number of the table");
        assert_eq!(document.text(), text(new));
    }
}

const KEYS: &str = "const fn keys(of: Movement) -> &'static [Key] {\n    match of {\n        Movement::Wave => &[],\n        \
    Movement::Nod => &[&[(HeadPitch, -37.0), (HeadYaw, 1.0)], &[ /* rest */ ]],\n    }\n}\n\
    const LONG: [Frame; 2] = [\n    Frame::new(1, [2]), // one\n    // two\n    Frame::new(3, [4]) // three\n];\n\
    const SHORT: [Frame; N] = [Frame { seconds: 1.0, posture: STAND }];\nconst ONE: Frame = Frame { seconds: 1.0, posture: STAND };\n\
    const SHORTER: [Frame; 2] = [Frame::new(1, [2, 3, 4, 5, 6, 7, 8, 9]), Frame::new(1, [2, 3, 4, 5, 6, 7, 8, 9])];\n";

#[test]
fn only_the_named_bytes_change() {
    for (edit, from, to) in [
        (r#""set_numbers", "table": "Nod", "numbers": [{"row": 0, "cell": "HeadPitch", "value": 5}]"#, "-37.0", "5.0"),
        (r#""set_numbers", "table": "Nod", "numbers": [{"row": 0, "cell": "HeadPitch"}]"#, "(HeadPitch, -37.0), ", ""),
        (r#""set_numbers", "table": "Nod", "numbers": [{"row": 0, "cell": "HeadYaw"}]"#, ", (HeadYaw, 1.0)", ""),
        (
            r#""set_numbers", "table": "Nod", "numbers": [{"row": 0, "cell": "Arm", "value": 2}]"#,
            ", 1.0)]",
            ", 1.0), (Arm, 2.0)]",
        ),
        (
            r#""set_numbers", "table": "Nod", "numbers": [{"row": 0, "cell": "HeadPitch"}, {"row": 0, "cell": "HeadYaw", "value": 2},
                {"row": 0, "cell": "Arm", "value": 3}, {"row": 1, "cell": "Arm", "value": 4}, {"row": 1, "cell": "Leg", "value": 5}]"#,
            "(HeadPitch, -37.0), (HeadYaw, 1.0)], &[ /* rest */ ]",
            "(HeadYaw, 2.0), (Arm, 3.0)], &[(Arm, 4.0), (Leg, 5.0)]",
        ),
        (r#""insert_row", "table": "Wave", "before": 0, "code": "&[]""#, "Wave => &[]", "Wave => &[&[]]"),
        (r#""insert_row", "table": "Nod", "before": 0, "copy": 1"#, "&[&[(Head", "&[&[ /* rest */ ], &[(Head"),
        (
            r#""insert_row", "table": "Nod", "before": 1, "code": "&[(A, 1.0), (B, 2.0), (C, 3.0)]""#,
            "&[ /* rest */ ]",
            "&[(A, 1.0), (B, 2.0), (C, 3.0)], &[ /* rest */ ]",
        ),
        (
            r#""insert_row", "table": "SHORTER", "before": 9, "copy": 0"#,
            "2] = [Frame::new(1, [2, 3, 4, 5, 6, 7, 8, 9]), Frame::new(1, [2, 3, 4, 5, 6, 7, 8, 9])]",
            "3] = [\n    Frame::new(1, [2, 3, 4, 5, 6, 7, 8, 9]),\n    \
                Frame::new(1, [2, 3, 4, 5, 6, 7, 8, 9]),\n    Frame::new(1, [2, 3, 4, 5, 6, 7, 8, 9]),\n]",
        ),
        (r#""delete_row", "table": "Nod", "row": 1"#, ", &[ /* rest */ ]", ""),
        (r#""delete_row", "table": "LONG", "row": 0"#, "2] = [\n    Frame::new(1, [2]), //", "1] = [\n     //"),
        (
            r#""delete_row", "table": "LONG", "row": 1"#,
            "2] = [\n    Frame::new(1, [2]), // one\n    // two\n    Frame::new(3, [4])",
            "1] = [\n    Frame::new(1, [2])",
        ),
    ] {
        let after = edited(KEYS, &format!(r#"{{"edit": {edit}}}"#));
        assert_eq!(after, Ok(KEYS.replacen(from, to, 1)), "{edit}");
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    for (edit, message) in [
        (r#""set_numbers", "table": "Run", "numbers": []"#, "no table `Run`"),
        (r#""set_numbers", "table": "ONE", "numbers": [{"row": 1, "cell": "seconds", "value": 1}]"#, "has 1 rows"),
        (
            r#""set_numbers", "table": "ONE", "numbers": [{"row": 0, "cell": "posture", "value": 1}]"#,
            "`STAND` is not a number",
        ),
        (
            r#""set_numbers", "table": "ONE", "numbers": [{"row": 0, "cell": "x", "value": 1}]"#,
            "no number `x`: there is `seconds`",
        ),
        (r#""set_numbers", "table": "Nod", "numbers": [{"row": 0, "cell": "A, 1), (B", "value": 1}]"#, "is not a name"),
        (r#""insert_row", "table": "Nod", "before": 0, "code": "1, 2""#, "is not an expression"),
        (r#""insert_row", "table": "ONE", "before": 0, "copy": 0"#, "is one row"),
        (r#""insert_row", "table": "SHORT", "before": 0, "copy": 0"#, "the length of `SHORT` is `N`"),
        (r#""delete_row", "table": "LONG", "row": 2"#, "has 2 rows"),
    ] {
        let refused = edited(KEYS, &format!(r#"{{"edit": {edit}}}"#)).expect_err(edit);
        assert!(refused.contains(message), "{edit}: {refused}");
    }
}
