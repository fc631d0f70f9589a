// Jobs begun and not yet saved: putting the panel away keeps them, Cancel and Save forget them.
import type { Drawing } from './drawing'

export interface Begun {
  drawing: Drawing
  description: string
}

const begun = new Map<string, Begun>()

export const keptDraft = (doc: string): Begun | undefined => begun.get(doc)
export const keepDraft = (doc: string, draft: Begun): void => void begun.set(doc, draft)
export const forgetDraft = (doc: string): boolean => begun.delete(doc)
