//! The program prints the output that the README shows.

use super::{ROOT, dialogues, folder, is_a_scene, run, scene};

fn readme() -> String {
    std::fs::read_to_string(format!("{ROOT}/README.md")).expect("is there")
}

fn printed(arguments: &[String]) -> String {
    let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
    let output = run(&arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn the_dialogue_is_what_is_printed() {
    let readme = readme();
    let block =
        readme.split("```text\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a dialogue");
    let dialogues = dialogues(block, "examples/scenes/");
    for (arguments, told) in &dialogues {
        assert_eq!(printed(arguments), *told, "{arguments:?}");
    }
    assert_eq!(dialogues.len(), 3);
}

#[test]
fn every_command_of_the_table_answers() {
    let (readme, output) = (readme(), folder("readme"));
    let mut commands = 0;
    for line in readme.lines().filter(|line| line.starts_with("| ")) {
        let command = line.rsplit_once("`grasp-lcp ").and_then(|(_, rest)| rest.strip_suffix("` |"));
        // Commands with redirected input are skipped.
        let Some(command) = command.filter(|command| !command.contains('<')) else { continue };
        let mut arguments: Vec<_> = command
            .split_whitespace()
            .map(|word| if is_a_scene(word) { scene(word) } else { word.to_owned() })
            .collect();
        if command.starts_with("map") {
            arguments.extend(["--output".to_owned(), output.display().to_string()]);
        }
        assert!(!printed(&arguments).is_empty(), "{command}");
        commands += 1;
    }
    assert_eq!(commands, 19);
}

/// The README is short.
#[test]
fn it_has_less_than_a_thousand_words() {
    let words = readme().split_whitespace().count();
    assert!(words <= 1000, "{words}");
}
