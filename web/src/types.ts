// What the engine answers (web/page_json.hpp, web/deck_places.hpp).

export interface Deck {
  name: string;
  text: string;
  /** What the deck names: included decks, terrain; by the name that it uses. */
  files: Record<string, string>;
}

export interface DeckError {
  file: string;
  line: number;
  column: number;
  width: number;
  message: string;
}

export interface Check {
  name: string;
  part: string;
  value: string;
  limit: string;
  sense: string;
  utilisation: number | null;
  share: string;
  outcome: string;
  rule: string;
  trust: string;
  where: string;
}

export interface Curve {
  label: string;
  x: (number | null)[];
  y: (number | null)[];
  dashed: boolean;
  points: boolean;
}

export interface PlotData {
  name: string;
  title: string;
  caption: string;
  x: { label: string; unit: string };
  y: { label: string; unit: string };
  curves: Curve[];
  marks: { x: number | null; y: number | null; label: string; level: boolean; upright: boolean }[];
  /** The scene over whose times it runs, and what its x shows of a second; null: it runs over something else. */
  over: { scene: string; second: number } | null;
}

export interface SceneLine {
  name: string;
  points: (number | null)[][];
  tension: (number | null)[][];
}

export interface Scene {
  name: string;
  t: number[];
  times: string[];
  events: { t: number; text: string }[];
  lines: SceneLine[];
  points: { name: string; radius: number; at: [number, number, number][] }[];
  tension: { least: number; most: number; least_text: string; most_text: string } | null;
}

export interface Page {
  title: string;
  method: string;
  status: string;
  message: string;
  verdict: { kind: string; words: string; reason: string } | null;
  headline: string;
  answers: { label: string; text: string }[];
  warnings: { text: string; unsafe: boolean }[];
  errors: DeckError[];
  values: { name: string; label: string; text: string; heading: string; detail: boolean }[];
  checks: Check[];
  plots: PlotData[];
  pictures: number;
  scenes: Scene[];
  ground: (number | null)[];
  interrupted: boolean;
}

export interface Picture {
  title: string;
  caption: string;
  scale: string;
  svg: string;
}

export interface HandleNumber {
  from: number;
  to: number;
  unit: string;
  factor: number;
  decimals: number;
  /** In SI, as it stands in the text. */
  value: number;
  along: [number, number, number];
  least?: number;
}

export interface Handle {
  path: string;
  name: string;
  kind: string;
  /** The part of the result at which it stands; its `at` comes from the picture. */
  on?: string;
  at: [number, number, number];
  numbers: HandleNumber[];
}

export interface OutlineNode {
  path: string;
  kind: 'null' | 'scalar' | 'sequence' | 'map';
  value: [number, number];
  key?: [number, number];
  text?: string;
}

export interface Places {
  outline?: OutlineNode[];
  handles?: Handle[];
}

export interface Answer {
  page?: Page;
  places?: Places;
  failure?: string;
  /** Time that the engine took, in ms. */
  took: number;
}

/** What calculates for the page: a worker (engine.ts), or the program that sent the page (remote.ts). */
export interface PageEngine {
  onProgress: (progress: Progress | null) => void;
  version: string;
  start(): Promise<void>;
  /** True: solve answers with what is done. */
  stop(): Promise<boolean | void>;
  /** Null: a later deck was given meanwhile. */
  solve(deck: Deck): Promise<Answer | null>;
  ask(what: string): Promise<string>;
}

export interface Progress {
  what: string;
  done: number;
  words: string;
}
