//! The editor `CodeMirror`: its packages as one module.
//!
//! It comes as many packages that import each other by name. esbuild, also from npm in an exact version and with a
//! checked checksum, joins what the page needs of them; the same versions give the same bytes.

use std::fs;
use std::path::Path;

use super::{Library, read, unpack};
use crate::process::{root, run};

/// Name of the module.
pub(super) const FILE: &str = "codemirror.js";

/// What the page imports.
const ENTRY: &str = r"
export { Annotation, ChangeSet, Compartment, EditorSelection, EditorState, Prec, RangeSetBuilder, StateEffect, StateField, Transaction } from '@codemirror/state';
export { Decoration, EditorView, drawSelection, dropCursor, WidgetType, highlightActiveLine, highlightActiveLineGutter, highlightSpecialChars, keymap, lineNumbers } from '@codemirror/view';
export { defaultKeymap, indentWithTab } from '@codemirror/commands';
export { HighlightStyle, bracketMatching, indentOnInput, indentUnit, syntaxHighlighting, syntaxTree } from '@codemirror/language';
export { rust } from '@codemirror/lang-rust';
export { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap, startCompletion } from '@codemirror/autocomplete';
export { lintGutter, lintKeymap, setDiagnostics } from '@codemirror/lint';
export { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
export { tags } from '@lezer/highlight';
export { StyleModule } from 'style-mod';
";

/// The program that joins them, for 64-bit Linux.
const ESBUILD: Library = part(
    "@esbuild/linux-x64",
    "0.28.2",
    "e314d9af5154992a105b85c85a68addedcd0ad44d933e3773f45d5f3144e298179d177c8ef178ef74fb56d9bcdc3122e7d0f610d0551247e588603d517c03f1d",
);

pub(super) const PACKAGES: &[Library] = &[
    part(
        "@codemirror/state",
        "6.7.6",
        "900cfe027711b4ab8892779dc53d5bab85f05efe14a3085b9075359b23ebb556ff8d9b48996b95e415f3bf9bcaea2de46000ac76266240a15043932aede956f3",
    ),
    part(
        "@codemirror/view",
        "6.43.15",
        "1c7b1fa6a15e1f25cbb3df37a5245edfc5da8ecd2f156650d81b97d26eca8bcc378d9e620fc72e477941cf6ff9fd7e770e17f7d920472a1eabb524c1ead29e1b",
    ),
    part(
        "@codemirror/commands",
        "6.11.1",
        "3bfe211b7482d58c1c990d1dd9454d0ecf80b1a3567758875716d378406ea87fba6c4c4088f2b7892fc1be963aad91944402efe190f7b0881c0a646fc377a106",
    ),
    part(
        "@codemirror/language",
        "6.13.1",
        "cdfbd4dabdd3cb29502cc8ffb5efb90a7434ad2a998bc075a130816d091a81c2d6e1773a8a669beaa37ea44261b2e34e2da26a891c815e9f548560350e156f0f",
    ),
    part(
        "@codemirror/streamparser",
        "6.0.0",
        "25314f17ac6b7e3b749a77c63e0cdc2e2330626bc8c8d6a88b3a7c058ceff0513c2ab4fa181183675f74aedb7e3bb5a47b7806fcc147ca263d60635e8a6a1fe3",
    ),
    part(
        "@codemirror/lang-rust",
        "6.0.2",
        "1196868c251e82d894ee448cbce7c466968245ea3011fdf2362758bbbfaf7ee1939bda30e26b610296ab639862b09a8e1e6268c151f7529bbe7899548e2eaaa8",
    ),
    part(
        "@codemirror/autocomplete",
        "6.20.4",
        "c85f1184e7f6497960d34faab6ea732e1ae095c6aceb56e8a9a38d88d71b3c879b1c2a49a1ca6a4c103a772aed52b40ee3b86ac9375ea1bff75e7622953ed369",
    ),
    part(
        "@codemirror/lint",
        "6.9.8",
        "a8dbed704ef7c54b68fc3d51bed812448e00d4783c7a4c65bed6698c7a5da62b0b067872bbcd8450424c1206b1923b90080f2faa7af294435628eb040c238773",
    ),
    part(
        "@codemirror/search",
        "6.7.2",
        "8146246214f6fa7ffe54667ef04cc4e56164619519626d5538a0ee748b0daa1e36b915502746ba62cb3db1d293dcc78e61fb8bd4de80640e7ba336b43b2af42c",
    ),
    part(
        "@lezer/common",
        "1.5.5",
        "3f0ecf5429ddaee175a5bdde6c2c69495a643074838f04422dc4d1c3e462cd429ca3941b5b2970ab68389671bf45837bc934d00d713d17beccc2d900ca986b8e",
    ),
    part(
        "@lezer/highlight",
        "1.2.5",
        "3b518c54a82d7f962ca45691ce99aa91580cb489361c6f6e3006c7eb074021d361dd35730ac721ffe7118beea5dbffd418329ee8d07d056ddcbee4797b3310d3",
    ),
    part(
        "@lezer/lr",
        "1.4.12",
        "3a7f47538a0c3221cf3244038284e719a863806e67fcc90ddfc0a01bbeec32b68a2cbfb72416de40d8b515c09757d411ab017dfc15173f771a1f2242d5f04e4d",
    ),
    part(
        "@lezer/rust",
        "1.0.3",
        "5f112b3a367343bc89b756a0513e1fbbda90bc4499dda720a31a4f68f4cf3a2531f9db828da540b59185220a61907c65374e5d8dd54020ecbfc08b5284c123a9",
    ),
    part(
        "@marijn/find-cluster-break",
        "1.0.4",
        "5b2d15efe4865239c5f7f4e488cd612950cf8fb8ca5ddb8f35ba0c56d1d303c77248c5115aa7e0fc967d1364aaf09812266925ee4ed07bd14b78c4ab4ab69699",
    ),
    part(
        "crelt",
        "1.0.7",
        "68ae816d67e17f853fc0270b1ca3c997fc5ae95915b2d45a3f2c16b4c286c2e38b73fc194f2418ba8c60bd99cdb01befeca83761305061804282072f890733b8",
    ),
    part(
        "style-mod",
        "4.1.4",
        "5d758842deb7dff129005c7c6990ce4e3073ac26869a1bc4425428e8c54f7dad8ecced9c5a8fb8855f61fba5241d895719fcbe3835ca51d3fb3ed86672ee404f",
    ),
    part(
        "w3c-keyname",
        "2.2.8",
        "769a2306136c08d37b4fcd939bb936e80e86f4c2f7364843b27c3d9ff7a8c52465541078084b4843f29308b2361707f76ad6925d1858164422dd29671703ef3d",
    ),
];

const fn part(package: &'static str, version: &'static str, sha512: &'static str) -> Library {
    Library { package, version, sha512, licence: "LICENSE", files: &[] }
}

/// Returns the module and the licences of all packages, each once.
pub(super) fn bundle() -> Result<Vec<(String, Vec<u8>)>, String> {
    let folder = root().join("target/vendor/bundle");
    let modules = folder.join("node_modules");
    let _ = fs::remove_dir_all(&folder);
    let mut licences = String::new();
    for library in PACKAGES {
        let unpacked = unpack(library)?;
        let text = String::from_utf8_lossy(&read(&unpacked.join(library.licence))?).into_owned();
        licences += &[library.package, " ", library.version, "\n\n", text.trim_end(), "\n\n"].concat();
        place(&unpacked, &modules.join(library.package))?;
    }
    let (entry, result) = (folder.join("entry.js"), folder.join(FILE));
    fs::write(&entry, ENTRY).map_err(|error| format!("cannot write {}: {error}", entry.display()))?;
    let program = unpack(&ESBUILD)?.join("bin/esbuild");
    let output = format!("--outfile={}", result.display());
    let arguments = [
        &*entry.to_string_lossy(),
        "--bundle",
        "--format=esm",
        "--minify",
        "--charset=utf8",
        "--legal-comments=none",
        "--log-level=warning",
        &output,
    ];
    run(&program.to_string_lossy(), &arguments, &[])?;
    Ok(vec![(FILE.to_owned(), read(&result)?), ("codemirror.LICENSE.txt".to_owned(), licences.into_bytes())])
}

fn place(unpacked: &Path, to: &Path) -> Result<(), String> {
    let error = |error| format!("cannot make {}: {error}", to.display());
    to.parent().map_or(Ok(()), fs::create_dir_all).map_err(error)?;
    fs::rename(unpacked, to).map_err(error)
}

/// Rows of the table in the folder's README.
pub(super) fn rows() -> String {
    let row = |library: &Library| {
        format!("| {} | {} | {FILE} | MIT, codemirror.LICENSE.txt |\n", library.package, library.version)
    };
    PACKAGES.iter().map(row).collect()
}
