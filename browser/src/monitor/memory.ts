// The memory of a running subsystem's variables: checked, and its present readings saved to a file (A12).
import { act } from '../act/act'
import { notify } from '../act/toasts.svelte'
import { desk } from '../link/desk.svelte'
import type { Reason } from '../texts/say'
import { plain } from '../texts/say'
import { t } from '../texts/index.svelte'
import { save } from '../act/save'

/** What is unsound stands in the log, each finding as a line; that all is sound is said too. */
export async function checkMemory(doc: string): Promise<void> {
  const findings = await act({ t: 'CheckMemory', doc })
  if (findings === undefined) return
  const unsound = Array.isArray(findings) ? (findings as Reason[]) : []
  for (const text of unsound) notify({ t: 'Say', level: 'error', text, doc })
  if (unsound.length) return
  const name = desk.tree.documents[doc]?.subsystem ?? ''
  notify({ t: 'Say', level: 'success', text: plain(t('memory.sound', { name })), doc })
}

/** All present readings, exactly as they are, as a file of the user's. */
export async function saveReadings(doc: string): Promise<void> {
  const text = await act({ t: 'LogReadings', doc })
  if (typeof text !== 'string') return
  const moment = new Date()
  const head = `# ${t('memory.readingsAt', { moment: moment.toISOString() })}\n`
  const name = desk.tree.documents[doc]?.name ?? doc
  save(`${name}-${moment.toISOString().slice(0, 19).replaceAll(':', '-')}.log`, new Blob([head, text]))
}
