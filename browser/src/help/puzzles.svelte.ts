// The puzzles of the search path, as the environment told them last; it keeps how far one is.
import { act } from '../act/act'
import { show } from '../act/documents.svelte'
import type { PuzzlesView, PuzzleView } from '../api.gen'

export const puzzles: { all: readonly PuzzleView[] } = $state({ all: [] })

export async function listPuzzles(): Promise<void> {
  const answer = (await act({ t: 'ListPuzzles' })) as PuzzlesView | null | undefined
  if (answer) puzzles.all = answer.puzzles ?? []
}

/** Open what a puzzle begins with; false where it was refused. */
export async function beginPuzzle(name: string): Promise<boolean> {
  const id = await act({ t: 'BeginPuzzle', puzzle: name })
  if (typeof id !== 'string') return false
  show(id)
  return true
}
