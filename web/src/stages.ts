// What a job does, in the words of common/util/stage_words.cc: a test compares the two lists.

const STAGES: [string, string][] = [ // by the beginning of a phase, or of a task's stage
  ['measure', 'measure levels'], ['survey', 'look at the tiles'], ['ground', 'tell ground from objects'],
  ['plan', 'find the holes'], ['sample', 'fit the surface'], ['smooth', 'smooth the seams'],
  ['fill', 'fill the holes'], ['assemble', 'write the tiles'], ['verify', 'verify the tiles']];

export function stageText(phase: string): string {
  return STAGES.find(([beginning]) => phase.startsWith(beginning))?.[1] ?? phase.replaceAll('_', ' ');
}
