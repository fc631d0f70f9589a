// Icons begun and not yet saved: putting a panel away keeps them, Cancel and Save forget them.
import type { Drawing } from './drawing'

export interface Begun {
  drawing: Drawing
  description: string
  /** Of a target: its values. */
  words?: string[]
  /** Of one that is new. */
  name?: string
  type?: string
}

const begun = new Map<string, Begun>()

export const keptDraft = (of: string): Begun | undefined => begun.get(of)
export const keepDraft = (of: string, draft: Begun): void => void begun.set(of, draft)
export const forgetDraft = (of: string): boolean => begun.delete(of)
