// Colours of the scene on light and dark ground.
import type { Theme } from '../../state';

export interface Palette {
  ground: string;
  grid: string;
  route: string;
  duct: string;
  floor: string;
  belt: string;
  steel: string;
  drum: string;
  frame: string;
  obstacle: string;
  environment: string;
}

export const PALETTES: Record<Theme, Palette> = {
  light: {
    ground: '#f4f6f8',
    grid: '#9aa7b4',
    route: '#5c6b7a',
    duct: '#4a78a8',
    floor: '#b9b1a2',
    belt: '#3f5f68',
    steel: '#b3bdc7',
    drum: '#b98d5e',
    frame: '#59636e',
    obstacle: '#b0532f',
    environment: '#cfd4da',
  },
  dark: {
    ground: '#12171d',
    grid: '#465362',
    route: '#8796a6',
    duct: '#7fb0e6',
    floor: '#5b574f',
    belt: '#6f97a2',
    steel: '#6b7783',
    drum: '#a87f54',
    frame: '#98a4b0',
    obstacle: '#d9774f',
    environment: '#46515d',
  },
};
