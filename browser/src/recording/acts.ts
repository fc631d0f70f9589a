// What a user does with the recording that is looked at.
import { act } from '../act/act'
import { save } from '../act/save'
import { notify } from '../act/toasts.svelte'
import { announce } from '../state/announce'
import type { RecordingFile, RecordingsView, RecordingView, SharedFileView } from '../api.gen'
import { look } from '../state/look.svelte'
import { kept } from '../state/kept'
import { clockText, seconds } from '../sentences/words'
import { choicesText } from '../application/redirectChoices'
import { plain, say } from '../texts/say'
import { t } from '../texts/index.svelte'
import { review } from './review.svelte'
import { KEPT, NONE, valuesOf } from './tolerance'

export const closeRecording = (): Promise<unknown> => act({ t: 'CloseRecording' })

/** Go on in the simulator from the instant that is shown. */
export function continueHere(): Promise<unknown> {
  review.isPlaying = false
  return act({ t: 'Continue', at_s: review.at_s })
}

/** Show another run beside, compared with the tolerances that were typed last; false where it was refused. */
export async function compareWith(path: string): Promise<boolean> {
  return (await act({ t: 'CompareWith', path, ...valuesOf(kept(KEPT, NONE)) })) !== undefined
}

export async function openRecording(path: string): Promise<boolean> {
  return (await act({ t: 'OpenRecording', path })) !== undefined
}

/** Have a file made of the recording that plays by itself, and hand it to the browser to save. */
export async function share(): Promise<void> {
  const recording = review.recording
  if (!recording || review.isSharing) return
  review.isSharing = true
  announce(t('share.making'))
  const file = (await act({ t: 'ShareRecording' }).finally(() => (review.isSharing = false))) as
    SharedFileView | undefined
  if (!file) return
  const content = new Blob([file.text], { type: 'text/html' })
  save(file.name, content)
  const said = t('share.made', { file: file.name, size: sizeOf(content.size) })
  const text = file.every_s ? `${said} ${t('share.coarse', { seconds: seconds(file.every_s, 2) })}` : said
  notify({ t: 'Say', level: 'success', text: plain(text), doc: '', at_s: Date.now() / 1000 })
}

/** Where recordings lie, and which there are; undefined where that was refused. */
export const recordings = async (): Promise<RecordingsView | undefined> =>
  (await act({ t: 'Recordings' })) as RecordingsView | undefined

/** To the next mark, and say what it is. */
export function toMark(way: 1 | -1): void {
  const at_s = review.toMark(way)
  const marks = (review.recording?.marks ?? []).filter((mark) => mark.at_s === at_s)
  const sentences = marks.map((mark) => say(mark.text)).join(', ')
  announce(at_s === undefined ? t('review.noMark') : `${clockText(at_s)} ${sentences}`)
}

/** When it began, in the words of this browser's language. */
export function whenOf(file: Pick<RecordingFile, 'began_at_s'>): string {
  const began = new Date((file.began_at_s ?? 0) * 1000)
  const isThisYear = began.getFullYear() === new Date().getFullYear()
  return file.began_at_s
    ? new Intl.DateTimeFormat(look.language, {
        day: 'numeric',
        month: 'short',
        year: isThisYear ? undefined : 'numeric',
        hour: '2-digit',
        minute: '2-digit',
        second: '2-digit',
        hourCycle: 'h23',
      }).format(began)
    : ''
}

/** What tells it from others of the same application: when it began, whether in a simulator, and who stood for whom. */
export const aboutOf = (recording: RecordingView): string =>
  [whenOf(recording), recording.is_virtual ? t('review.simulated') : '', choicesText(recording.redirects ?? [])]
    .filter(Boolean)
    .join(' · ')

/** As `12.4 s` or `3:05 min`. */
export function lengthOf(took_s: number): string {
  if (took_s < 60) return t('review.time', { seconds: seconds(took_s) })
  return `${Math.floor(took_s / 60)}:${String(Math.floor(took_s % 60)).padStart(2, '0')} min`
}

export function sizeOf(bytes: number): string {
  const units = ['B', 'kB', 'MB', 'GB']
  const power = Math.min(units.length - 1, Math.max(0, Math.floor(Math.log10(Math.max(1, bytes)) / 3)))
  return `${seconds(bytes / 1000 ** power, power && bytes / 1000 ** power < 10 ? 1 : 0)} ${units[power]}`
}
