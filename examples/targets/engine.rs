//! A WebAssembly engine for the examples that run on boards.

use wasmi::{Caller, Engine, Extern, Linker, Module, Store};

/// The global in which a module counts its instructions, if it does.
pub const COUNTER: &str = "executed instructions";

/// What a program prints.
pub fn interpret(bytes: &[u8]) -> Result<String, wasmi::Error> {
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
