// Three short tunes, made of sine waves: success rises, an error falls, an end is a chord. No files.
import type { Say } from '../api.gen'

/** Pitch in Hz and when it begins, in seconds. */
type Note = readonly [hz: number, at_s: number]

export const TUNES: Partial<Record<Say['level'], readonly Note[]>> = {
  success: [
    [660, 0],
    [880, 0.09],
  ],
  error: [
    [330, 0],
    [220, 0.14],
  ],
  end: [
    [523, 0],
    [659, 0.1],
    [784, 0.2],
  ],
}
const LENGTH_S = 0.16
const LOUD = 0.08

let audio: AudioContext | undefined

export function play(level: Say['level']): void {
  const tune = TUNES[level]
  if (!tune || navigator.userActivation?.hasBeenActive === false) return // a browser is silent until its user has touched the page
  try {
    audio ??= new AudioContext()
    if (audio.state === 'suspended') void audio.resume()
    for (const [hz, at_s] of tune) beep(audio, hz, audio.currentTime + at_s)
  } catch {
    // no sound on this machine; the words are on the screen
  }
}

function beep(context: AudioContext, hz: number, at_s: number): void {
  const [wave, volume] = [context.createOscillator(), context.createGain()]
  wave.frequency.value = hz
  volume.gain.setValueAtTime(0, at_s)
  volume.gain.linearRampToValueAtTime(LOUD, at_s + 0.015)
  volume.gain.exponentialRampToValueAtTime(0.0001, at_s + LENGTH_S)
  wave.connect(volume).connect(context.destination)
  wave.start(at_s)
  wave.stop(at_s + LENGTH_S)
}
