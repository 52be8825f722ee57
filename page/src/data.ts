/** What the program writes into the page: docs/page.md describes it. Nothing here names a metric. */
import type { Recommendation, Terms } from './recommendation';

/** How a key is written for people; its unit as text, empty for a pure number. */
export interface KeyInfo {
  words: string;
  unit: string;
  definition?: string;
}

export interface Program {
  version: string;
  git_revision?: string;
  compiler?: string;
  physics?: number;
}

export interface Barrier {
  foot_x_m: number;
  height_m: number;
  thickness_m: number;
  stem_lean_deg: number;
  deflector: { angle_deg: number; length_m: number } | null;
  outline: [number, number][];
}

export interface Scene {
  slope_deg: number;
  gravity_m_s2: number;
  domain: { length_m: number; height_m: number };
  reservoir: { length_m: number; height_m: number };
  monitor_x_m: number;
  density_kg_m3: number;
  barriers: Barrier[];
  solids: [number, number][][];
}

/** A run whose scene, series and recording the page may hold. Blocks are ids of script elements. */
export interface Run {
  scene?: Scene;
  series?: string;
  recording?: string;
  /** Windows of the running means of which the loads are the largest. */
  windows?: { barrier: number; key: string; value: number; from_s: number; to_s: number }[];
  /** How to make a recording that is not there. */
  record_command?: string;
}

export interface Common {
  format: string;
  kind: 'study' | 'simulation' | 'sweep' | 'validation' | 'studies';
  name: string;
  description: string;
  date: string;
  hash: string;
  /** Which wrote the page. */
  program: Program;
  /** Which simulated what it shows, where that is known. */
  simulated_by?: Program | null;
  keys: Record<string, KeyInfo>;
  commands: { what: string; command: string }[];
  runs: Record<string, Run>;
  live?: boolean;
}

export interface Variable {
  name: string;
  lower?: number;
  upper?: number;
  options?: string[];
}

/** Every evaluated design, a list per quantity, all of one length. */
export interface Designs {
  id: string[];
  stage: string[];
  spacing_m: number[];
  status: string[];
  reason: string[];
  feasible: boolean[];
  front: boolean[];
  stop_reason: string[];
  warnings: string[][];
  variables: Record<string, (number | string | null)[]>;
  objectives: Record<string, (number | null)[]>;
  constraints: Record<string, (number | null)[]>;
  metrics: Record<string, (number | null)[]>;
  /** Of several studies: whether each was simulated at the spacing that counts in its study. */
  counts?: boolean[];
}

/** Designs that one table holds: of a study, or of several. */
export interface DesignsPage extends Common {
  variables: Variable[];
  objectives: Terms[];
  finest_spacing_m?: number;
  designs: Designs;
}

/** One of several studies. */
export interface MemberStudy {
  label: string;
  folder: string;
  hash: string;
  simulated_by?: Program | null;
  state: string;
  spacing_m: number;
  designs: number;
  feasible: number;
  on_joint_front: number;
  recommended: string | null;
}

export interface StudiesPage extends DesignsPage {
  kind: 'studies';
  notes: string[];
  studies: MemberStudy[];
}

/** The surrogate along one variable through a design. */
export interface Slice {
  variable: string;
  at: (number | string)[];
  median: number[];
  lower_95: number[];
  upper_95: number[];
}

export interface StudyPage extends DesignsPage {
  kind: 'study';
  state: string;
  recommendation: Recommendation;
  slices: { design: string; metrics: { name: string; metric: string; slices: Slice[] }[] } | null;
}

export interface Uncertainty {
  expanded_95: number;
  discretisation: number;
  scatter: number;
  extrapolated: number;
  order: number;
  order_observed: boolean;
  runs: number;
}

export interface SimulationResult {
  name: string;
  status: string;
  reason: string;
  stop_reason: string;
  stop_time_s: number;
  metrics: Record<string, number | null>;
  metrics_absent: Record<string, string>;
  uncertainty?: Record<string, Uncertainty>;
  warnings?: { key: string; value: number; limit: number; text: string }[];
  mass: Record<string, number>;
  statistics: Record<string, number>;
}

export interface SimulationPage extends Common {
  kind: 'simulation';
  result: SimulationResult;
}

export interface Published {
  value?: number;
  lower?: number;
  upper?: number;
  source?: string;
  note?: string;
}

export interface SweepRow {
  id: string;
  description: string;
  status: string;
  reason: string;
  metrics: Record<string, number | null>;
  metrics_absent: Record<string, string>;
  paper: Record<string, Published>;
  agreement: Record<string, { verdict: string; distance?: number }>;
}

export interface SweepPage extends Common {
  kind: 'sweep';
  source: string;
  spacing_m: number;
  rows: SweepRow[];
}

export interface Measure {
  key: string;
  what: string;
  value: number | null;
  unit?: string;
  lower?: number;
  upper?: number;
  verdict: string;
  reason?: string;
  explanation?: string;
}

export interface ValidationPage extends Common {
  kind: 'validation';
  cases: { case: string; title: string; suite: string; failure?: string; measures: Measure[] }[];
  figures: { case: string; file: string; block: string }[];
}

export type Page = StudyPage | StudiesPage | SimulationPage | SweepPage | ValidationPage;
