//! The program `conformance` on every machine.

use wasmi::{Caller, Engine, Extern, Linker, Module, Store};

use crate::cargo;
use crate::library::run;
use crate::target::WASM;

/// What the program prints on a board.
pub fn on_board(target: &str) -> Result<String, String> {
    run(&mut cargo::example("run", "conformance", target, "release"))
}

/// What the program prints on this machine.
pub fn here() -> Result<String, String> {
    run(&mut cargo::example_here("conformance"))
}

/// What the program prints in a WebAssembly engine.
pub fn on_wasm() -> Result<String, String> {
    run(&mut cargo::example("build", "conformance", WASM, "release"))?;
    let file = cargo::program("conformance.wasm", WASM, "release");
    let bytes = std::fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    interpret(&bytes).map_err(|error| format!("{}: {error}", file.display()))
}

fn interpret(bytes: &[u8]) -> Result<String, wasmi::Error> {
    let engine = Engine::default();
    let module = Module::new(&engine, bytes)?;
    let mut store = Store::new(&engine, String::new());
    let mut linker = Linker::new(&engine);
    linker.func_wrap("board", "write", |mut caller: Caller<'_, String>, text: u32, length: u32| {
        let Some(Extern::Memory(memory)) = caller.get_export("memory") else { return };
        let range = text as usize..text as usize + length as usize;
        let bytes = memory.data(&caller).get(range).unwrap_or_default().to_vec();
        caller.data_mut().push_str(&String::from_utf8_lossy(&bytes));
    })?;
    let instance = linker.instantiate_and_start(&mut store, &module)?;
    let ended_well = instance.get_typed_func::<(), i32>(&store, "start")?.call(&mut store, ())?;
    if ended_well == 0 {
        return Err(wasmi::Error::new("the program found something wrong"));
    }
    Ok(store.into_data())
}
