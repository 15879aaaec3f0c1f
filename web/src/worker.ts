// The engine in a worker: a classic script, as a page from disk can start no other. The glue that emscripten makes
// (tautEngine) stands before this text in the same file.

interface EngineModule {
  _taut_solve(request: number): number;
  _taut_ask(what: number): number;
  _malloc(bytes: number): number;
  _free(at: number): void;
  UTF8ToString(at: number): string;
  stringToUTF8(text: string, at: number, bytes: number): void;
  lengthBytesUTF8(text: string): number;
}

declare function tautEngine(options: object): Promise<EngineModule>;

export type Message =
  | { kind: 'start'; packed?: string; url?: string; module?: WebAssembly.Module }
  | { kind: 'solve'; id: number; deck: object }
  | { kind: 'ask'; id: number; what: string };

const scope = self as unknown as DedicatedWorkerGlobalScope;
let engine: EngineModule | null = null;

async function unpacked(base64: string): Promise<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

async function compiled(r: Message & { kind: 'start' }): Promise<WebAssembly.Module> {
  if (r.module) return r.module;
  if (r.packed) return WebAssembly.compile(await unpacked(r.packed));
  const answer = await fetch(r.url ?? '');
  if (!answer.ok) throw new Error(`the engine cannot be loaded: ${answer.status}`);
  return WebAssembly.compile(await answer.arrayBuffer());
}

let lastTold = 0;

async function start(r: Message & { kind: 'start' }): Promise<void> {
  const module = await compiled(r);
  engine = await tautEngine({
    instantiateWasm(imports: WebAssembly.Imports, done: (i: WebAssembly.Instance) => void) {
      void WebAssembly.instantiate(module, imports).then(done);
      return {};
    },
    onProgress(what: string, done: number, words: string) {
      const now = performance.now();
      if (now - lastTold > 100) {
        lastTold = now;
        scope.postMessage({ kind: 'progress', what, done, words });
      }
      return true;
    },
  });
  scope.postMessage({ kind: 'ready', module: r.module ? undefined : module, version: call('_taut_ask', 'version') });
}

function call(name: '_taut_solve' | '_taut_ask', text: string): string {
  if (!engine) throw new Error('the engine has not started');
  const bytes = engine.lengthBytesUTF8(text) + 1;
  const at = engine._malloc(bytes);
  engine.stringToUTF8(text, at, bytes);
  try {
    return engine.UTF8ToString(engine[name](at));
  } finally {
    engine._free(at);
  }
}

scope.onmessage = async (event: MessageEvent<Message>) => {
  const r = event.data;
  try {
    if (r.kind === 'start') {
      await start(r);
    } else if (r.kind === 'solve') {
      const began = performance.now();
      const answer = JSON.parse(call('_taut_solve', JSON.stringify(r.deck)));
      scope.postMessage({ kind: 'answer', id: r.id, answer: { ...answer, took: performance.now() - began } });
    } else {
      scope.postMessage({ kind: 'answer', id: r.id, answer: call('_taut_ask', r.what) });
    }
  } catch (error) {
    // after a trap (memory at its end) the engine's state is unknown: the page starts another one
    scope.postMessage({ kind: 'broken', text: error instanceof Error ? error.message : String(error) });
  }
};
