/** What recommendation.json says, as far as the page shows it: docs/formats.md describes the file. */

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

export interface Terms {
  name: string;
  metric?: string;
  expression?: string;
  goal: 'maximize' | 'minimize';
  statistic?: string;
}

export interface Estimate extends Terms {
  value: number | null;
  estimate: number | null;
  lower_95: number | null;
  upper_95: number | null;
}

export interface ConstraintResult {
  name: string;
  metric?: string;
  expression?: string;
  statistic?: string;
  value: number | null;
  lower: number | null;
  upper: number | null;
  satisfied: boolean;
  margin: number | null;
  margin_percent: number | null;
  active: boolean;
}

export interface VariableResult {
  name: string;
  value?: number;
  option?: string;
  lower?: number;
  upper?: number;
  at_bound: 'lower' | 'upper' | null;
}

export interface DesignReport {
  id: string;
  stage: string;
  spacing_m: number;
  variables: VariableResult[];
  objectives: (Terms & { value: number | null; absent?: boolean })[];
  constraints: ConstraintResult[];
  metrics: Record<string, number | null>;
  metrics_absent: Record<string, string>;
  estimates?: Estimate[];
  probability_feasible?: number | null;
}

export interface ConfirmingRun {
  id: string;
  stage: string;
  spacing_m: number;
  ok: boolean;
  reason: string;
  feasible: boolean;
  objectives: (number | null)[];
  violated: string[];
  worse: string[];
}

export interface Spread {
  name: string;
  metric: string;
  runs: number;
  least: number;
  greatest: number;
  standard_deviation: number;
}

export interface Sobol {
  value: number;
  lower_95: number;
  upper_95: number;
}

export interface MainEffect {
  at: (number | string)[];
  mean: number[];
  lower_95: number[];
  upper_95: number[];
}

export interface Sensitivity {
  domain: string;
  metrics: {
    name: string;
    metric: string;
    designs: number;
    q_squared: number | null;
    varies: boolean;
    variables: { name: string; first: Sobol; total: Sobol; main_effect: MainEffect }[];
  }[];
}

/** A quantity of page one: what a repeat of the built design would give. */
export interface PageOneLine {
  label: string;
  text: string;
  asked: string;
  mean: number | null;
  lower_95: number | null;
  upper_95: number | null;
  probability: number | null;
}

/** What recommendation.md has on its first page. Sentences are whole; empty ones say nothing. */
export interface PageOne {
  title: string;
  design: string;
  arrangement: string;
  instead: string;
  performance: PageOneLine[];
  limits: PageOneLine[];
  loads: PageOneLine[];
  probability: number | null;
  probability_words: string;
  chosen: string;
  ties: string;
  bounds: string;
  grid: string;
  verdict: 'confirmed' | 'narrow' | 'untested' | 'refuted' | 'none';
  verdict_words: string;
}

/** The parts of recommendation.json that the page shows; all may be missing. */
export interface Recommendation {
  page_one?: PageOne;
  rule?: { name: string; words: string };
  recommended?: DesignReport | null;
  least_violating?: DesignReport | null;
  confirmation?: {
    verdict: string;
    runs: ConfirmingRun[];
    spread: Spread[];
    refuted: { id: string; violated: string[]; worse: string[] }[];
  } | null;
  front?: { id: string; objectives: Estimate[]; probability_feasible: number | null }[];
  hypervolume?: {
    value: number | null;
    history: { evaluations: number; hypervolume: number | null }[];
  } | null;
  sensitivity?: Sensitivity | null;
  caveats?: string[];
  improvement?: {
    start_id: string;
    same_design: boolean;
    objectives: { name: string; start: number | null; best: number | null; better: boolean | null }[];
  } | null;
  study?: Record<string, Json>;
  definitions?: Record<string, string>;
}
