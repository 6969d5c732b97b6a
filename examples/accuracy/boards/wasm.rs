//! The example `sweep` in a WebAssembly engine.

use wasmi::{Caller, Engine, Extern, Linker, Module, Store};

use super::cargo;
use super::counted::{COUNTER, counted};
use super::library;
use super::machine::Machine;
use super::program::Program;

/// What the program prints.
pub fn run(program: &Program) -> Result<String, String> {
    library::run(&mut Machine::Wasm.command("build", program))?;
    let file = cargo::program("sweep.wasm", Machine::Wasm.target(), "release");
    let bytes = std::fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    let bytes = counted(&bytes).map_err(|error| format!("{}: {error}", file.display()))?;
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
    linker.func_wrap("board", "instructions", |caller: Caller<'_, String>| {
        let count = caller.get_export(COUNTER).and_then(Extern::into_global);
        count.and_then(|count| count.get(&caller).i64()).unwrap_or_default()
    })?;
    let instance = linker.instantiate_and_start(&mut store, &module)?;
    let ended_well = instance.get_typed_func::<(), i32>(&store, "start")?.call(&mut store, ())?;
    if ended_well == 0 {
        return Err(wasmi::Error::new("the program found something wrong"));
    }
    Ok(store.into_data())
}
