// The upper level as this browser shows it: which application, and what is picked in it and in the dictionaries.
import { SvelteSet } from 'svelte/reactivity'
import { kept } from './kept'

/** A place in an application: behind this step of this flow; 0 is the start icon. */
export interface Place {
  flow: string
  after: number
}

interface Workspace {
  /** Id of the application shown; empty: none is open. */
  app: string
  /** The steps picked in it, by their numbers. */
  steps: SvelteSet<number>
  /** Where the next icon goes: the insertion cursor. */
  place: Place
  /** The dictionary shown, by its path; empty: all together. */
  dictionary: string
  /** The icon selected in it. */
  onikon: string
  /** Whether the dictionary shows only what fits at `place`. */
  fitsOnly: boolean
  /** Whether targets that were made for other arms are offered too. */
  showsEveryArm: boolean
}

export const workspace: Workspace = $state({
  app: '',
  steps: new SvelteSet<number>(),
  place: { flow: '0', after: 0 },
  dictionary: kept('dictionary', ''),
  onikon: '',
  fitsOnly: false,
  showsEveryArm: false,
})

/** Pick these steps of the application and nothing else. */
export function pickSteps(...steps: number[]): void {
  workspace.steps.clear()
  for (const step of steps) workspace.steps.add(step)
}
